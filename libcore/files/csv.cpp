// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/csv.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace impinge {
namespace {

template <class Number>
std::string shortest(Number number) {
  std::array<char, 32> buffer{};  // a double needs 24 characters, a 64-bit integer 20
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  return {buffer.data(), end};
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + '"';
}

}  // namespace

std::string Cell::text() const {
  if (const auto* text = std::get_if<std::string>(&value_)) return quoted(*text);
  if (const auto* count = std::get_if<std::int64_t>(&value_)) return shortest(*count);
  if (const auto* number = std::get_if<double>(&value_)) return std::isnan(*number) ? "" : shortest(*number);
  return "";
}

void Table::add_row(std::vector<Cell> row) {
  if (row.size() != columns.size()) {
    throw std::invalid_argument("a row of " + std::to_string(row.size()) + " cells in a table of " +
                                std::to_string(columns.size()) + " columns");
  }
  rows.push_back(std::move(row));
}

std::string csv_line(const std::vector<Cell>& cells) {
  std::string line;
  for (const Cell& cell : cells) line += (&cell == &cells.front() ? "" : ",") + cell.text();
  return line + "\n";
}

std::string to_csv(const Table& table) {
  std::vector<Cell> head;
  for (const Column& column : table.columns) head.emplace_back(column.name);
  std::string text = csv_line(head);
  for (const auto& row : table.rows) text += csv_line(row);
  return text;
}

}  // namespace impinge

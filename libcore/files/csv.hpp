// SPDX-License-Identifier: GPL-3.0-or-later
// A tidy CSV table: declared columns, one header line, no comments, one observation a row.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace impinge {

/// What a column holds. The unit is "1" for counts and ratios and "" for text.
struct Column {
  std::string name;     // as in the header line
  std::string unit;     // such as "mm"
  std::string meaning;  // one clause
};

/// A value, or nothing (an empty cell). Construct it from text, any integer, a floating-point number or a
/// bool; a bool is written as yes or no.
class Cell {
 public:
  Cell() = default;
  Cell(std::string text) : value_(std::move(text)) {}            // text
  Cell(std::string_view text) : value_(std::string(text)) {}     // text
  Cell(const char* text) : value_(std::string(text)) {}          // text
  Cell(double number) : value_(number) {}                        // a number; empty for NaN
  Cell(bool flag) : value_(std::string(flag ? "yes" : "no")) {}  // yes or no
  /// A whole number; it must fit into a signed integer of 64 bits.
  template <std::integral I>
  Cell(I number) : value_(static_cast<std::int64_t>(number)) {}

  /// Shortest decimal text that reads back as the same double; empty for NaN; RFC 4180 quotes where needed.
  std::string text() const;

 private:
  std::variant<std::monostate, std::string, std::int64_t, double> value_;
};

/// Columns and the rows below them.
struct Table {
  std::vector<Column> columns;               // in the order of the cells
  std::vector<std::vector<Cell>> rows = {};  // each with a cell for every column

  /// Throws std::invalid_argument unless there is one cell for each column.
  void add_row(std::vector<Cell> row);
};

/// The bytes of the file: lines end in a line feed.
std::string to_csv(const Table& table);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// A tidy CSV table: declared columns, one header line, one observation on each line below it, no comments.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace impinge {

/// What a column holds.
struct Column {
  std::string name;     // as in the header line
  std::string unit;     // such as "mm"; "1" for counts and ratios, "" for text
  std::string meaning;  // one clause
};

/// One value of a table: text, a whole number, a floating-point number or a bool; or nothing, an empty cell.
class Cell {
 public:
  Cell() = default;
  Cell(std::string text) : value_(std::move(text)) {}            // text
  Cell(std::string_view text) : value_(std::string(text)) {}     // text
  Cell(const char* text) : value_(std::string(text)) {}          // text
  Cell(double number) : value_(number) {}                        // a number; NaN gives an empty cell
  Cell(bool flag) : value_(std::string(flag ? "yes" : "no")) {}  // the word yes or no
  /// A whole number; it must fit into a signed integer of 64 bits.
  template <std::integral I>
  Cell(I number) : value_(static_cast<std::int64_t>(number)) {}

  /// The cell as it is written: a number as the shortest decimal text that reads back as the same double, NaN
  /// as nothing, text in quotes where RFC 4180 asks for them.
  std::string text() const;

 private:
  std::variant<std::monostate, std::string, std::int64_t, double> value_;
};

/// A table with its columns.
struct Table {
  std::vector<Column> columns;               // in the order of the cells
  std::vector<std::vector<Cell>> rows = {};  // each with a cell for every column

  /// Appends a row. Throws std::invalid_argument unless it has one cell for each column.
  void add_row(std::vector<Cell> row);
};

/// Cells as a line of a CSV file.
std::string csv_line(const std::vector<Cell>& cells);

/// The table as the bytes of a CSV file, whose lines end in a line feed.
std::string to_csv(const Table& table);

}  // namespace impinge

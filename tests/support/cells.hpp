// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of a table of results by the names of their columns.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "files/csv.hpp"

namespace impinge::test {

// std::out_of_range where there is no such row or column.
inline std::string cell(const Table& table, std::size_t row, std::string_view column) {
  const auto at = std::ranges::find(table.columns, column, &Column::name) - table.columns.begin();
  return table.rows.at(row).at(static_cast<std::size_t>(at)).text();
}

inline double number(const Table& table, std::size_t row, std::string_view column) {
  return std::stod(cell(table, row, column));
}

}  // namespace impinge::test

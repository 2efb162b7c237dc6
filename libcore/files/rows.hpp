// SPDX-License-Identifier: GPL-3.0-or-later
// Makes rows of a CSV from structs that are described with files/fields.hpp.
#pragma once

#include <string>
#include <vector>

#include "files/csv.hpp"
#include "files/fields.hpp"

namespace impinge {

/// The columns of a table whose rows are of this type: one for each field.
template <Described Row>
std::vector<Column> columns_of() {
  std::vector<Column> columns;
  for_each_field<Row>([&](const auto& field) {
    columns.push_back({std::string(field.name), std::string(field.unit), std::string(field.text)});
  });
  return columns;
}

template <class T>
Cell cell_of(const T& value) {
  if constexpr (InWords<T>) {
    return word_of(value);
  } else if constexpr (requires { value.has_value(); }) {
    return value ? cell_of(*value) : Cell();
  } else {
    return value;
  }
}

/// The cells of one row, in the order of columns_of().
template <Described Row>
std::vector<Cell> cells_of(const Row& row) {
  std::vector<Cell> cells;
  for_each_field<Row>([&](const auto& field) { cells.push_back(cell_of(field.of(row))); });
  return cells;
}

}  // namespace impinge

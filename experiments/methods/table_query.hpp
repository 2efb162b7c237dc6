// SPDX-License-Identifier: GPL-3.0-or-later
// Any table as a query: radii or inverse depths, in double or stored in fewer bytes.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>

#include "methods/points.hpp"

namespace impinge::lab {

// Bytes of entries and rim mask.
template <class Table>
std::size_t table_bytes(const Table& table) {
  if constexpr (requires { table.bytes(); }) {
    return table.bytes();
  } else {
    return Table::bytes(table.scheme()) + table.rim_cells().bytes();
  }
}

// Radius along direction(i), mm.
template <class Table>
double entry_radius(const Table& table, std::size_t i) {
  if constexpr (requires { table.radii(); }) {
    return table.radii()[i];
  } else if constexpr (requires { table.inverse_depths(); }) {
    return 1.0 / (table.inverse_depths()[i] * table.scheme().depth(table.scheme().direction(i)));
  } else {
    return table.entry_radius(i);
  }
}

/// Of a table that has been filled.
template <class Table>
PointQuery table_query(Table filled) {
  const auto table = std::make_shared<const Table>(std::move(filled));
  PointQuery query = one_by_one([table](const Vec3& x) { return table->radius_at(x); },
                                static_cast<double>(table_bytes(*table)));
  if constexpr (requires { table->storage_bound(); }) query.storage_bound = table->storage_bound();
  query.stored = [table] {
    StoredRadii stored;
    stored.reach = table->scheme().stencil_radius();
    for (std::size_t i = 0; i < table->scheme().size(); ++i) {
      stored.directions.push_back(table->scheme().direction(i));
      stored.radii.push_back(entry_radius(*table, i));
    }
    return stored;
  };
  return query;
}

}  // namespace impinge::lab

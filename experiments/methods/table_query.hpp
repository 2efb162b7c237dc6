// SPDX-License-Identifier: GPL-3.0-or-later
// Any table as a query: radii or inverse depths, in double or stored in fewer bytes.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>

#include "methods/points.hpp"

namespace impinge::lab {

/// The query of a filled table.
template <class Table>
PointQuery table_query(Table filled) {
  const auto table = std::make_shared<const Table>(std::move(filled));
  PointQuery query =
      one_by_one([table](const Vec3& x) { return table->radius_at(x); }, static_cast<double>(table->bytes()));
  if constexpr (requires { table->storage_bound(); }) query.storage_bound = table->storage_bound();
  query.stored = [table] {
    StoredRadii stored;
    stored.reach = table->scheme().stencil_radius();
    for (std::size_t i = 0; i < table->scheme().size(); ++i) {
      stored.directions.push_back(table->scheme().direction(i));
      stored.radii.push_back(table->radius_of(i));
    }
    return stored;
  };
  return query;
}

}  // namespace impinge::lab

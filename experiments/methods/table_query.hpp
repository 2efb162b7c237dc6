// SPDX-License-Identifier: GPL-3.0-or-later
// Any table as a query: radii or inverse depths, in double or stored in fewer bytes.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "files/csv.hpp"
#include "methods/points.hpp"
#include "table/own_scheme.hpp"

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

// Proven bounds of tables that are filled exactly from a mesh.

/// The name of a precision (degrees) in results, such as "0.5deg".
inline std::string degrees_text(double precision) { return Cell(precision).text() + "deg"; }

/// The table of a precision (degrees). `mesh` is in the centre frame; `layer` is its layer that counts.
template <SamplingScheme S>
RadialTable<S> exact_radii_of(const TriangleMesh& mesh, double precision, Layer layer) {
  return fill_exact(mesh, S::with_precision(precision), layer);
}

template <class Table>
MethodBound bound_of(const TriangleMesh& mesh, Layer layer, const Table& table, const TableBenchmark& bench) {
  if (table.scheme().size() <= bench.most_entries && mesh.faces.size() <= bench.most_faces) {
    const TableBound found = table_bound(mesh, table, layer, bench.search);
    return {found.bound_mm, found.attained_mm};
  }
  return {first_order_bound(mesh, table).bound_mm};
}

}  // namespace impinge::lab

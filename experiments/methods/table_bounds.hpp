// SPDX-License-Identifier: GPL-3.0-or-later
// Proven bounds of tables that are filled exactly from the surface of a scene.
#pragma once

#include <string>

#include "files/csv.hpp"
#include "methods/points.hpp"
#include "table/own_scheme.hpp"

namespace impinge::lab {

/// The name of a precision (degrees) in results, such as "0.5deg".
inline std::string degrees_text(double precision) { return Cell(precision).text() + "deg"; }

/// The table of a precision (degrees) for the layer that scenes ask; mesh in the centre frame.
template <SamplingScheme S>
RadialTable<S> exact_radii_of(const TriangleMesh& mesh, double precision) {
  return fill_exact(mesh, S::with_precision(precision), BenchmarkScene::kLayer);
}

template <class Table>
MethodBound bound_of(const BenchmarkScene& scene, const Table& table, const TableBenchmark& bench) {
  if (table.scheme().size() <= bench.most_entries && scene.surface().faces.size() <= bench.most_faces) {
    const TableBound found = table_bound(scene.surface(), table, BenchmarkScene::kLayer, bench.search);
    return {found.bound_mm, found.attained_mm};
  }
  return {first_order_bound(scene.surface(), table).bound_mm};
}

}  // namespace impinge::lab

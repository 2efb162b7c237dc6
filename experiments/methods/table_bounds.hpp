// SPDX-License-Identifier: GPL-3.0-or-later
// What is proven of tables that are filled exactly from the surface of a scene.
#pragma once

#include <string>

#include "files/csv.hpp"
#include "methods/points.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {

/// How results call a precision.
inline std::string degrees_text(double precision) { return Cell(precision).text() + "deg"; }

/// Filled from the surface of the scene.
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

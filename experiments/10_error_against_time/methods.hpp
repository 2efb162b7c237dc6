// SPDX-License-Identifier: GPL-3.0-or-later
// All methods of the benchmark on one scene. The scene outlives them.
#pragma once

#include <cstddef>
#include <vector>

#include "methods/radius_method.hpp"
#include "table/table_bound.hpp"

namespace impinge::lab {

// Which tables run, and how tightly they are bounded.
struct TableBenchmark {
  std::vector<double> precisions;  // degrees
  // Tables of no more entries, of surfaces of no more faces, are bounded by branch and bound, see
  // table/table_bound.hpp; other tables of radii by the bound of first order, which costs little and is
  // loose, other tables of inverse depths not at all.
  std::size_t most_entries = 0;
  std::size_t most_faces = 0;  // see above
  BoundOptions search;         // of branch and bound
};

// Every scheme of every precision it can have, in double, float and 16 bits; those whose entries
// lie on a solid also with inverse depths, as SCHEME_mesh_exact. Filled exactly.
std::vector<MethodMaker> table_methods(const BenchmarkScene& scene, const TableBenchmark& bench);

// rsid_thesis and usid_thesis: the tables of the thesis, filled as the thesis does, in double.
std::vector<MethodMaker> thesis_methods(const BenchmarkScene& scene, const TableBenchmark& bench);

// What libraries offer, brute force, and distance grids with so many nodes a side.
std::vector<MethodMaker> other_methods(const BenchmarkScene& scene,
                                       const std::vector<std::size_t>& grid_nodes);

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of a scheme that kernels are made from, and what is asked of all of them.
#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "gap/simd/gap_kernels.hpp"
#include "table/own_scheme.hpp"
#include "table/packed_fixture.hpp"

namespace impinge::test {

// Proven of what the kernels of the scheme keep, before any search, mm.
template <class S>
double bound_of(const TriangleMesh& mesh, const RadialTable<S>& radii, Layer layer) {
  if constexpr (std::same_as<S, CubeGnomonic>) {
    return table_bound(mesh, InverseDepthTable<S>(radii), layer, {1.0, 0}).bound_mm;
  } else {
    return table_bound(mesh, radii, layer, {1.0, 0}).bound_mm;
  }
}

// Of the kernel of that table, mm.
template <class Table>
std::vector<double> gaps_of(const Table& table, const std::vector<Vec3>& vertices, const Pose& pose,
                            Surface scanned) {
  using Real = typename Table::Real;
  std::vector<Real> gap(vertices.size());
  scan_gaps(table, packed_vertices<Real>(vertices), pose, scanned, gap);
  return {gap.begin(), gap.end()};
}

// Of one scheme; shared by what it is stored as.
template <class S>
struct Filled {
  RadialTable<S> radii;   // mm
  double bound_mm = 0.0;  // proven, before any search; 0 if it was not asked for
};

// From a mesh.
template <class S>
std::shared_ptr<const Filled<S>> filled(const TriangleMesh& mesh, Layer layer, double precision_deg,
                                        bool bounded) {
  auto radii = fill_exact(mesh, S::with_precision(precision_deg), layer);
  const double bound = bounded ? bound_of(mesh, radii, layer) : 0.0;
  return std::make_shared<const Filled<S>>(Filled<S>{std::move(radii), bound});
}

}  // namespace impinge::test

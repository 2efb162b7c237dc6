// SPDX-License-Identifier: GPL-3.0-or-later
// The entries of a scheme inside a spherical triangle, exactly.
#pragma once

#include <array>
#include <cstddef>

#include "sphere/walker.hpp"

namespace impinge {

/// Calls visit(entry, direction) once for every entry whose direction the cone contains, boundary included.
/// The tests of a run are computed together, which the compiler turns into vector instructions; those in
/// doubt are decided exactly.
template <class Walker, class Visit>
void for_each_entry_inside(const Walker& walker, const TriangleCone& cone, Visit&& visit) {
  const double doubt = cone.doubt();
  walker.visit_near(cone, 0.0, [&](const DirectionRun& run) {
    std::array<double, DirectionRun::kMost> least;
    for (std::size_t k = 0; k < run.count; ++k)
      least[k] = cone.least_edge_distance(run.x[k], run.y[k], run.z[k]);
    for (std::size_t k = 0; k < run.count; ++k) {
      if (least[k] < -doubt) continue;
      const Vec3 u = run[k];
      if (least[k] > doubt || cone.contains(u)) visit(run.first + k, u);
    }
  });
}

}  // namespace impinge

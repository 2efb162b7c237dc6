// SPDX-License-Identifier: GPL-3.0-or-later
// The proven bound of a table, as the race wants it.
#pragma once

#include <algorithm>
#include <cmath>

#include "contenders/radius_method.hpp"
#include "sampling/error_bound.hpp"
#include "sphere/inverse_depth_table.hpp"

namespace impinge {

// Of a table that was filled exactly from the mesh (centre frame).
template <SamplingScheme S>
MethodBound table_method_bound(const TriangleMesh& mesh, const RadialTable<S>& table, Layer /*layer*/) {
  const std::vector<float> slopes = largest_slopes(mesh, table.scheme());
  MethodBound bound;
  bound.bound_mm = 0.0;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    const double radius = table.radii()[i];
    if (std::isnan(radius)) continue;
    bound.bound_mm =
        std::max(bound.bound_mm, radius * std::expm1(slopes[i] * table.scheme().stencil_radius()));
  }
  return bound;
}
template <PlaneExactScheme S>
MethodBound table_method_bound(const TriangleMesh& /*mesh*/, const InverseDepthTable<S>& /*table*/,
                               Layer /*layer*/) {
  return {};
}

}  // namespace impinge

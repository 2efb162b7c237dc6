// SPDX-License-Identifier: GPL-3.0-or-later
// A proven bound on what interpolation in a table costs, direction by direction.
//
// Within a layer the radius is continuous and |d ln r / ds| <= tan psi. In a cell that no rim crosses there
// is a way from any direction u to each tap i, at most the stencil radius s long. With T_i the largest tan
// psi of the faces within s of the tap,
//   |r_i - r(u)| <= r_i (exp(T_i s) - 1),
// and the interpolated value, a mean of the r_i with weights w_i, errs by at most sum w_i r_i (exp(T_i s) -
// 1). First order in s: safe, and loose where a face is smooth and large (the error there is of second
// order).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {

// Largest tan psi within the stencil radius of each entry; infinite near a face whose plane holds the centre,
// 0 where there is no face. mesh in the centre frame.
template <SamplingScheme S>
std::vector<float> largest_slopes(const TriangleMesh& mesh, const S& scheme) {
  std::vector<float> slopes(scheme.size(), 0.0F);
  const auto& walker = scheme.walker();
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    const double slope = cone.edge_on() ? std::numeric_limits<double>::infinity() : cone.largest_slope();
    // A float may round down; one step up keeps the bound.
    const float safe = std::nextafter(static_cast<float>(slope), std::numeric_limits<float>::infinity());
    walker.visit_near(cone, scheme.stencil_radius(), [&](const DirectionRun& run) {
      for (std::size_t k = 0; k < run.count; ++k)
        slopes[run.first + k] = std::max(slopes[run.first + k], safe);
    });
  }
  return slopes;
}

// Bound on |table.radius_at(x) - radius of the mesh along x|, mm, for a table filled exactly and its
// largest_slopes(). kNoSurface where the table has no surface; infinite where the
// bound is above the radius itself and says nothing.
template <SamplingScheme S>
double error_bound_at(const RadialTable<S>& table, const std::vector<float>& slopes, const Vec3& x) {
  const Stencil stencil = table.scheme().stencil(x);
  if (table.is_rim_cell(stencil.cell)) return kNoSurface;
  const double reach = table.scheme().stencil_radius();
  double bound = 0.0;
  double radius = 0.0;
  for (std::size_t k = 0; k < stencil.taps; ++k) {
    const std::size_t i = stencil.entry[k];
    if (stencil.weight[k] == 0.0) continue;
    const double share = stencil.weight[k] * table.radii()[i];
    radius += share;
    bound += share * std::expm1(slopes[i] * reach);
  }
  return bound > radius ? std::numeric_limits<double>::infinity() : bound;
}

}  // namespace impinge

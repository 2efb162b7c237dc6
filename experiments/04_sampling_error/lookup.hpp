// SPDX-License-Identifier: GPL-3.0-or-later
// A look-up without a table: what a table answers along a direction when its entry i holds entry_radius(i).
// For a surface with a formula only the entries that are read are computed, so that a table of any size is
// examined without filling it.
#pragma once

#include <cstddef>

#include "sphere/scheme.hpp"

namespace impinge::lab {

// Linear in r, the interpolant of RadialTable::radius_at() away from a rim and equal to it bit for bit.
template <SamplingScheme S, class EntryRadius>
double smooth_radius(const S& scheme, const Vec3& u, const EntryRadius& entry_radius) {
  const Stencil stencil = scheme.stencil(u);
  double radius = 0.0;
  for (std::size_t k = 0; k < stencil.taps; ++k) {
    if (stencil.weight[k] > 0.0) radius += stencil.weight[k] * entry_radius(stencil.entry[k]);
  }
  return radius;
}

// Linear in 1 / (r depth), the interpolant of InverseDepthTable::radius_at() away from a rim.
template <PlaneExactScheme S, class EntryRadius>
double plane_exact_radius(const S& scheme, const Vec3& u, const EntryRadius& entry_radius) {
  const Stencil stencil = scheme.plane_stencil(u);
  double inverse = 0.0;
  for (std::size_t k = 0; k < stencil.taps; ++k) {
    if (!(stencil.weight[k] > 0.0)) continue;
    const std::size_t i = stencil.entry[k];
    inverse += stencil.weight[k] / (entry_radius(i) * scheme.depth(scheme.direction(i)));
  }
  return 1.0 / (scheme.depth(u) * inverse);
}

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// What a way of looking up entries costs on a surface that is known exactly.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "sphere/scheme.hpp"

namespace impinge {

/// Of interpolated minus true radius, mm.
struct LookupError {
  double largest = 0.0;           // in size
  double root_mean_square = 0.0;  // over the directions
};

/// Interpolates the radii of the entries with stencil(u) -> Stencil in each direction u (unit vectors, at
/// least one) and compares with radius(u). All radii in mm.
template <class StencilOf>
LookupError lookup_error(std::span<const double> radii, StencilOf&& stencil,
                         const std::function<double(const Vec3&)>& radius, std::span<const Vec3> directions) {
  LookupError error;
  double sum = 0.0;
  for (const Vec3& u : directions) {
    const Stencil taps = stencil(u);
    double interpolated = 0.0;
    for (std::size_t k = 0; k < taps.taps; ++k) interpolated += taps.weight[k] * radii[taps.entry[k]];
    const double off = interpolated - radius(u);
    error.largest = std::max(error.largest, std::abs(off));
    sum += off * off;
  }
  error.root_mean_square = std::sqrt(sum / static_cast<double>(directions.size()));
  return error;
}

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// What placements of a Spiral that treat an entry from the nearer pole have in common.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sphere/haversine.hpp"
#include "sphere/scheme.hpp"
#include "sphere/turn_angle.hpp"

namespace impinge {

/// Direction whose polar angle from the north pole, or else from the south pole, has this haversine.
inline Vec3 spiral_point(double hav, bool south, double turns) {
  const CosSin theta = turn_angle(turns);
  const double sin_phi = 2.0 * std::sqrt(hav * (1.0 - hav));
  const double cos_phi = 1.0 - 2.0 * hav;
  return {sin_phi * theta.cos, sin_phi * theta.sin, south ? -cos_phi : cos_phi};
}

/// Fills a run with the directions of a placement.
template <class P>
void fill_singly(const P& placement, DirectionRun& run) {
  for (std::size_t k = 0; k < run.count; ++k) {
    const Vec3 u = placement.direction(run.first + k);
    run.x[k] = u.x();
    run.y[k] = u.y();
    run.z[k] = u.z();
  }
}

/// Solid angle of the band from half a place before an entry to half a place after it, with sin^2(a / 2) -
/// sin^2(b / 2) = sin((a + b) / 2) sin((a - b) / 2).
template <class P>
double band_area(const P& placement, std::size_t entry) {
  const auto i = static_cast<double>(entry);
  const double from = placement.polar_angle(std::max(i - 0.5, 0.0));
  const double to = placement.polar_angle(std::min(i + 0.5, placement.last()));
  return 4.0 * kPi * std::sin(0.5 * (from + to)) * std::sin(0.5 * (to - from));
}

}  // namespace impinge

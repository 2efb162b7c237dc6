// SPDX-License-Identifier: GPL-3.0-or-later
// What a sampling scheme is worth, measured: none of these numbers is taken from the scheme's own
// declarations.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "scheme_metrics/sphere_delaunay.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

/// A gap with |z| above this counts as one at a pole: within 11.5 degrees of it.
inline constexpr double kAwayFromPoles = 0.98;

/// N rho^2 of the densest covering of the plane by circles, one on each corner of equilateral triangles
/// (Kershner 1939): no scheme of many entries is below 8 pi / (3 sqrt(3)) = 4.8368.
inline constexpr double kLeastCoveringConstant = 8.0 * kPi / (3.0 * 1.7320508075688772);

/// The measures of one scheme. Areas are solid angles, steradians.
struct SchemeMetrics {
  std::size_t entries = 0;     // of the table, those that repeat a direction counted
  std::size_t directions = 0;  // that differ
  EmptyCircle widest;          // its radius is the covering radius, radians
  EmptyCircle widest_away;     // of those with |z| <= kAwayFromPoles
  /// Largest over smallest area, where entries of one direction share its area: the waste of repeating them
  /// shows.
  double entry_area_ratio = 0.0;
  double direction_area_ratio = 0.0;  // the same without sharing

  /// N rho^2. A bound on the error of linear interpolation is M rho^2 / 2, M the largest second derivative,
  /// so that the memory for a given bound is in proportion to it.
  double covering_constant() const { return static_cast<double>(entries) * widest.radius * widest.radius; }
  /// The same of the gap away from the poles.
  double covering_constant_away() const {
    return static_cast<double>(entries) * widest_away.radius * widest_away.radius;
  }
};

/// Unit vectors, in the order of the entries.
template <SamplingScheme S>
std::vector<Vec3> all_directions(const S& scheme) {
  std::vector<Vec3> directions;
  directions.reserve(scheme.size());
  for (std::size_t i = 0; i < scheme.size(); ++i) directions.push_back(scheme.direction(i));
  return directions;
}

/// Of all entries of the scheme.
template <SamplingScheme S>
SphereDelaunay sphere_delaunay_of(const S& scheme) {
  return sphere_delaunay(all_directions(scheme));
}

/// From the Delaunay triangulation of all entries.
template <SamplingScheme S>
SchemeMetrics measure_scheme(const S& scheme) {
  const SphereDelaunay delaunay = sphere_delaunay_of(scheme);
  const std::vector<double> areas = voronoi_areas(delaunay);
  const std::vector<double> shares = entry_areas(delaunay);
  const auto [least, most] = std::ranges::minmax(shares);
  const auto [smallest, largest] = std::ranges::minmax(areas);
  return {scheme.size(),        delaunay.distinct.direction.size(),
          widest_gap(delaunay), widest_gap(delaunay, kAwayFromPoles),
          most / least,         largest / smallest};
}

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis' error formula, and what theory promises of a look-up on a plane.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sphere/scheme.hpp"

namespace impinge::lab {

// Eq. 7 of the thesis, mm: sqrt(2) pi r / n for n entries on the equator. Half the diagonal of a cell there,
// measured along a sphere of radius r: how far a point of the surface may be from an entry, not how wrong a
// radius is.
inline double thesis_sampling_error(double radius, std::size_t equator_points) {
  return std::sqrt(2.0) * kPi * radius / static_cast<double>(equator_points);
}

// Eq. 8: the same as a share of the radius.
inline double thesis_relative_error(std::size_t equator_points) {
  return thesis_sampling_error(1.0, equator_points);
}

// What a table answers along u when its entry i holds entry_radius(i): linear in r, equal to
// RadialTable::radius_at() away from a rim, bit for bit. Only the entries that are read are computed.
template <SamplingScheme S, class EntryRadius>
double smooth_radius(const S& scheme, const Vec3& u, const EntryRadius& entry_radius) {
  const Stencil stencil = scheme.stencil(u);
  double radius = 0.0;
  for (std::size_t k = 0; k < stencil.taps; ++k) {
    if (stencil.weight[k] > 0.0) radius += stencil.weight[k] * entry_radius(stencil.entry[k]);
  }
  return radius;
}

// The plane n.x = p, examined up to an incidence of `steepest` radians. Directions are unit vectors.
struct SlantedPlane {
  Vec3 normal = Vec3(0.48, 0.6, 0.64);  // n, unit: no line of a grid runs along or round it
  double distance = 22.0;               // p, mm
  double steepest = 75.0 * kDegree;     // below 90 degrees

  bool covers(const Vec3& u) const { return angle_between(normal, u) <= steepest; }
  double radius(const Vec3& u) const { return distance / normal.dot(u); }
  // tan psi = |grad r| / r, psi from the direction to the normal.
  double slope(const Vec3& u) const { return normal.cross(u).norm() / normal.dot(u); }
};

// |answer - truth| of a look-up on that plane, mm.
template <SamplingScheme S>
double error_on_plane(const SlantedPlane& plane, const S& scheme, const Vec3& u) {
  const auto entry_radius = [&](std::size_t i) { return plane.radius(scheme.direction(i)); };
  return std::abs(smooth_radius(scheme, u, entry_radius) - plane.radius(u));
}

// Its bound, mm, for taps that a circle of angular radius `rho` holds: rho^2 / 2 times the largest
// r (1 + 2 tan^2 psi) at u and the taps, the larger eigenvalue of the Hessian of r.
template <SamplingScheme S>
double planar_bound(const SlantedPlane& plane, const S& scheme, const Vec3& u, double rho) {
  const auto curvature = [&plane](const Vec3& x) {
    const double slope = plane.slope(x);
    return plane.radius(x) * (1.0 + 2.0 * slope * slope);
  };
  const Stencil stencil = scheme.stencil(u);
  double largest = curvature(u);
  for (std::size_t k = 0; k < stencil.taps; ++k)
    largest = std::max(largest, curvature(scheme.direction(stencil.entry[k])));
  return 0.5 * rho * rho * largest;
}

}  // namespace impinge::lab

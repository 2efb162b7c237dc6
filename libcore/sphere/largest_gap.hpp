// SPDX-License-Identifier: GPL-3.0-or-later
// Circles through entries, and from them the covering radius near a pole.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include <Eigen/Geometry>

#include "sphere/direction.hpp"

namespace impinge {

/// Angle d between the directions (phi_1, theta) and (phi_2, theta + theta_apart), radians, accurate if
/// small: hav d = hav(phi_1 - phi_2) + sin(phi_1) sin(phi_2) hav(theta_apart), hav a = sin(a / 2)^2.
inline double separation(double phi_1, double phi_2, double theta_apart) {
  const double along = std::sin(0.5 * (phi_1 - phi_2));
  const double across = std::sin(0.5 * theta_apart);
  const double hav = along * along + std::sin(phi_1) * std::sin(phi_2) * across * across;
  return 2.0 * std::asin(std::sqrt(std::min(hav, 1.0)));
}

/// The direction equally far from a, b and c, on the side of a.
inline Vec3 circumcentre(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  if (normal.squaredNorm() == 0.0) return Vec3::Zero();
  return (normal.dot(a) < 0.0 ? -1.0 : 1.0) * normal.normalized();
}

/// Radius of the smaller circle through three unit vectors, as an angle in radians; 0 if two are equal.
inline double circumradius(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 axis = (b - a).cross(c - a);
  return std::atan2(axis.cross(a).norm(), std::abs(axis.dot(a)));
}

/// The largest radius, in radians and below 90 degrees, of a circle without an entry inside whose centre has
/// z >= z_min. The direction farthest from all entries is the centre of a circle through three of them.
/// `reach` must not be smaller than the answer, and `entries` must hold all entries with z >= z_min and those
/// within 2 reach of them.
double largest_gap(std::span<const Vec3> entries, double z_min, double reach);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Circles through entries, and by them the covering radius near a pole.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include <Eigen/Geometry>

#include "sphere/direction.hpp"

namespace impinge {

/// Angle between the directions (phi_1, theta) and (phi_2, theta + theta_apart), accurate for small ones:
/// hav d = hav(phi_1 - phi_2) + sin(phi_1) sin(phi_2) hav(theta_apart), hav a = sin(a / 2)^2. Radians.
inline double separation(double phi_1, double phi_2, double theta_apart) {
  const double along = std::sin(0.5 * (phi_1 - phi_2));
  const double across = std::sin(0.5 * theta_apart);
  const double hav = along * along + std::sin(phi_1) * std::sin(phi_2) * across * across;
  return 2.0 * std::asin(std::sqrt(std::min(hav, 1.0)));
}

/// Direction as far from a, b and c, on the side of a.
inline Vec3 circumcentre(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  if (normal.squaredNorm() == 0.0) return Vec3::Zero();
  return (normal.dot(a) < 0.0 ? -1.0 : 1.0) * normal.normalized();
}

/// Angle from the middle of the smaller circle through three unit vectors to each of them, radians; 0 where
/// two are equal.
inline double circumradius(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 axis = (b - a).cross(c - a);
  return std::atan2(axis.cross(a).norm(), std::abs(axis.dot(a)));
}

/// Largest radius, below 90 degrees, of a circle with no entry inside whose centre has z >= z_min: what is
/// farthest from all entries is the centre of a circle through three of them. `reach` is no smaller than the
/// answer; `entries` hold all with z >= z_min and those within 2 reach of them. Radians.
double largest_gap(std::span<const Vec3> entries, double z_min, double reach);

}  // namespace impinge

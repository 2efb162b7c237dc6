// SPDX-License-Identifier: GPL-3.0-or-later
// The circle through three directions.
#pragma once

#include <cmath>

#include <Eigen/Geometry>

#include "sphere/direction.hpp"

namespace impinge {

/// Angle from the middle of the smaller circle through three unit vectors to each of them, radians; 0 where
/// two are equal.
inline double circumradius(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 axis = (b - a).cross(c - a);
  return std::atan2(axis.cross(a).norm(), std::abs(axis.dot(a)));
}

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Distance of a point from a triangle.
#pragma once

#include <algorithm>

#include <Eigen/Geometry>

#include "sphere/direction.hpp"

namespace impinge {

inline double squared_distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double squared = along.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (p - a - share * along).squaredNorm();
}

// mm^2. A point above the triangle is as far as its plane, any other as far as the nearest edge. Degenerate
// triangles are their edges.
inline double squared_distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const auto inside = [&](const Vec3& from, const Vec3& to) {
    return normal.dot((to - from).cross(p - from)) >= 0.0;
  };
  const double squared = normal.squaredNorm();
  if (squared > 0.0 && inside(a, b) && inside(b, c) && inside(c, a)) {
    const double height = normal.dot(p - a);
    return height * height / squared;
  }
  return std::min({squared_distance_to_segment(p, a, b), squared_distance_to_segment(p, b, c),
                   squared_distance_to_segment(p, c, a)});
}

}  // namespace impinge

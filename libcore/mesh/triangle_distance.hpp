// SPDX-License-Identifier: GPL-3.0-or-later
// Distances from a triangle, in double.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <Eigen/Geometry>

#include "sphere/direction.hpp"

namespace impinge {

using Triangle = std::array<Vec3, 3>;  // its corners, mm

/// Squared distance from p to the segment a - b, mm^2.
inline double squared_distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double squared = along.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (p - a - share * along).squaredNorm();
}

/// Squared distance from p to the nearest side of a triangle, mm^2.
inline double squared_distance_to_sides(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::min({squared_distance_to_segment(p, a, b), squared_distance_to_segment(p, b, c),
                   squared_distance_to_segment(p, c, a)});
}

/// Squared distance from p to a triangle, mm^2: to its plane if p projects into the triangle, else to the
/// nearest edge. A degenerate triangle counts as its edges.
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
  return squared_distance_to_sides(p, a, b, c);
}

/// The point of the segment a - b nearest to p, up to rounding.
inline Vec3 nearest_point(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double squared = along.squaredNorm();
  return a + (squared > 0.0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0) * along;
}

/// The point of the triangle nearest to p, up to rounding. However thin the triangle is, the result is one of
/// its points up to the rounding of lengths.
inline Vec3 nearest_point(const Vec3& p, const Triangle& of) {
  const auto& [a, b, c] = of;
  const Vec3 normal = (b - a).cross(c - a);
  const auto weight = [&](const Vec3& from, const Vec3& to) {
    return std::max(0.0, normal.dot((to - from).cross(p - from)));
  };
  Vec3 nearest = nearest_point(p, a, b);
  const auto take = [&](const Vec3& x) {
    if ((x - p).squaredNorm() < (nearest - p).squaredNorm()) nearest = x;
  };
  take(nearest_point(p, b, c));
  take(nearest_point(p, c, a));
  const Vec3 weights(weight(b, c), weight(c, a), weight(a, b));
  if (weights.sum() > 0.0) take((weights[0] * a + weights[1] * b + weights[2] * c) / weights.sum());
  return nearest;
}

/// Squared distance between the segments a0 - a1 and b0 - b1, mm^2: at an end of one of them, or between the
/// two lines if their nearest points are inside of the segments.
inline double squared_distance_of_segments(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  const double at_ends =
      std::min({squared_distance_to_segment(a0, b0, b1), squared_distance_to_segment(a1, b0, b1),
                squared_distance_to_segment(b0, a0, a1), squared_distance_to_segment(b1, a0, a1)});
  const Vec3 a = a1 - a0;
  const Vec3 b = b1 - b0;
  const Vec3 across = a.cross(b);
  const double squared = across.squaredNorm();
  if (!(squared > 0.0)) return at_ends;  // parallel
  const double s = (b0 - a0).cross(b).dot(across) / squared;
  const double t = (b0 - a0).cross(a).dot(across) / squared;
  if (!(s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0)) return at_ends;
  const double between = (b0 - a0).dot(across);
  return std::min(at_ends, between * between / squared);
}

/// Squared distance between two triangles that do not meet, mm^2: at a corner of one of them or between two
/// edges.
inline double squared_distance_of_triangles(const Triangle& s, const Triangle& t) {
  double least = squared_distance_to_triangle(s[0], t[0], t[1], t[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    least = std::min({least, squared_distance_to_triangle(s[i], t[0], t[1], t[2]),
                      squared_distance_to_triangle(t[i], s[0], s[1], s[2])});
    for (std::size_t j = 0; j < 3; ++j)
      least = std::min(least, squared_distance_of_segments(s[i], s[(i + 1) % 3], t[j], t[(j + 1) % 3]));
  }
  return least;
}

}  // namespace impinge

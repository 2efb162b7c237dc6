// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/part_distance.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "mesh/triangle_distance.hpp"

namespace impinge {
namespace {

constexpr double kError = 24.0 * 0x1p-53;  // of D / k

// Is the foot of x, in the plane of the face, outside of the face, whatever the rounding of the normal?
bool surely_outside(const Vec3& x, const TurnFace& face) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 side = face.corner[(k + 1) % 3] - face.corner[k];
    const Vec3 to = x - face.corner[k];
    const double error = kError * face.size * std::sqrt(side.squaredNorm() * to.squaredNorm());
    if (face.normal.dot(side.cross(to)) < -error) return true;
  }
  return false;
}

}  // namespace

double least_distance(const Vec3& x, const TurnFace& face) {
  const auto& [a, b, c] = face.corner;
  if (!face.thin) return std::sqrt(squared_distance_to_triangle(x, a, b, c));
  const double squared = squared_distance_to_sides(x, a, b, c);
  const double area = face.normal.norm();
  if (!(area > 0.0) || surely_outside(x, face)) return std::sqrt(squared);
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  const double by_edges = std::sqrt(std::max(0.0, squared - 1.01 * area * area / longest));
  const double by_plane = (std::abs(face.normal.dot(x - a)) - kError * (x - a).norm() * face.size) / area;
  return std::min(std::max(by_edges, by_plane), std::sqrt(squared));
}

double least_distance_of_edges(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  const double at_ends =
      std::sqrt(std::min({squared_distance_to_segment(a0, b0, b1), squared_distance_to_segment(a1, b0, b1),
                          squared_distance_to_segment(b0, a0, a1), squared_distance_to_segment(b1, a0, a1)}));
  const Vec3 a = a1 - a0;
  const Vec3 b = b1 - b0;
  const Vec3 from = b0 - a0;
  const Vec3 across = a.cross(b);
  const double squared = across.squaredNorm();
  if (!(squared > 0.0)) return at_ends;
  const double lengths = std::sqrt(a.squaredNorm() * b.squaredNorm());
  const double sine = std::sqrt(squared) / lengths;
  const double error = kError * from.norm() / sine;
  const double s = from.cross(b).dot(across) / squared;
  const double t = from.cross(a).dot(across) / squared;
  const double s_error = error / a.norm();
  const double t_error = error / b.norm();
  if (!(s > -s_error && s < 1.0 + s_error && t > -t_error && t < 1.0 + t_error)) return at_ends;
  const double between = std::abs(from.dot(across)) / std::sqrt(squared);
  if (sine >= kThin) return std::min(at_ends, between);
  const double shorter = std::sqrt(std::min(a.squaredNorm(), b.squaredNorm()));
  return std::min(at_ends, std::max({0.0, at_ends - sine * shorter, between - error}));
}

double least_distance(const TurnFace& s, const TurnFace& t) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < 3; ++i) {
    least = std::min({least, least_distance(s.corner[i], t), least_distance(t.corner[i], s)});
    for (std::size_t j = 0; j < 3; ++j)
      least = std::min(least, least_distance_of_edges(s.corner[i], s.corner[(i + 1) % 3], t.corner[j],
                                                      t.corner[(j + 1) % 3]));
  }
  return least;
}

}  // namespace impinge

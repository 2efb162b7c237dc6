// SPDX-License-Identifier: GPL-3.0-or-later
// A ball with a bump that a turn brings wholly under a cup, for cuts of either of them; and what single rays
// meet, face by face.
#pragma once

#include <algorithm>
#include <cmath>

#include "change/required_motion.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "phantoms/phantom.hpp"

namespace impinge {

inline constexpr double kHeadRadius = 22.0;
inline constexpr double kCupRadius = 26.0;
inline constexpr double kBumpHeight = 6.0;
inline constexpr double kBumpHalfWidth = 25.0 * kDegree;

inline double bump_radius(double polar) {
  if (polar >= kBumpHalfWidth) return kHeadRadius;
  const double c = std::cos(0.5 * kPi * polar / kBumpHalfWidth);
  return kHeadRadius + kBumpHeight * c * c;
}

// A bump about +x, 28 degrees below a cup round +z, which a turn about y brings wholly under the cup.
inline BallSocketPair bump_under_a_cup(std::size_t sides = 120, double step_deg = 1.0) {
  std::vector<LatheRing> rings;
  for (double at = 0.0; at < 24.9; at += step_deg) rings.push_back({at * kDegree, bump_radius(at * kDegree)});
  for (int k = 25; k < 180; k += 5) rings.push_back({k * kDegree, kHeadRadius});
  rings.push_back({kPi, kHeadRadius});
  const Vec3 top(std::cos(28.0 * kDegree), 0.0, -std::sin(28.0 * kDegree));
  return {revolve({rings, top, Vec3::Zero(), sides}),
          revolve({sphere_rings(kCupRadius, 87.0 * kDegree, kDegree), Vec3::UnitZ(), Vec3::Zero(), 180})};
}

inline constexpr double kWallRadius = 27.0;

// The same cup with a wall.
inline TriangleMesh cup_with_a_wall(double outside = kWallRadius) {
  std::vector<LatheRing> rings = sphere_rings(kCupRadius, 87.0 * kDegree, 3.0 * kDegree);
  std::vector<LatheRing> back = sphere_rings(outside, 87.0 * kDegree, 3.0 * kDegree);
  rings.insert(rings.end(), back.rbegin(), back.rend());
  return revolve({rings, Vec3::UnitZ(), Vec3::Zero(), 120});
}

inline RequiredLeg turn_about_y(double degrees) {
  RequiredLeg leg;
  leg.turn = {Eigen::Matrix3d::Identity(), -Vec3::UnitY(), Eigen::Matrix3d::Identity()};
  leg.growing = "flexion";
  leg.largest_deg = degrees;
  return leg;
}

// Radius of a face along u (Moeller and Trumbore 1997), infinite where it is not met.
inline double radius_along(const TriangleMesh& mesh, const Face& face, const Vec3& u) {
  const Vec3 a = corner(mesh, face, 0);
  const Vec3 ab = corner(mesh, face, 1) - a;
  const Vec3 ac = corner(mesh, face, 2) - a;
  const Vec3 across = u.cross(ac);
  const double determinant = ab.dot(across);
  const double v = -a.dot(across) / determinant;
  const double w = u.dot((-a).cross(ab)) / determinant;
  const double radius = ac.dot((-a).cross(ab)) / determinant;
  return v >= 0.0 && w >= 0.0 && v + w <= 1.0 && radius > 0.0 ? radius : HUGE_VAL;
}

}  // namespace impinge

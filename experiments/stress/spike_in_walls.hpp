// SPDX-License-Identifier: GPL-3.0-or-later
// A ball with a spike in a cube of six walls: how far its tip is from the wall has a closed form. What is
// proven of rotations is asked as near to contact as could be.
#pragma once

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "mesh/ball_socket_pair.hpp"
#include "mesh/bodies.hpp"
#include "motion/required_motion.hpp"
#include "motion/rotation_cells.hpp"
#include "stress/family.hpp"

namespace impinge::lab {

inline constexpr double kWallDistance = 26.0;  // mm, of the walls
inline constexpr double kTipTilt = 0.2;        // radians from the wall's normal, +z: well beside the side
inline constexpr double kTipAround = 0.4;      // between the wall's triangles; and about that normal

// Direction of the tip in the socket's frame, as far from the normal.
inline Vec3 tip_direction(double tilt) {
  return {std::sin(tilt) * std::cos(kTipAround), std::sin(tilt) * std::sin(kTipAround), std::cos(tilt)};
}

// Eight corners, two triangles a wall.
inline TriangleMesh six_walls() {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.vertices.push_back(kWallDistance * Vec3((k & 1) != 0 ? 1.0 : -1.0, (k & 2) != 0 ? 1.0 : -1.0,
                                                 (k & 4) != 0 ? 1.0 : -1.0));
  mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

// The ball lies so that `rotation` brings its tip, `length` mm out, to tip_direction(kTipTilt). Every other
// corner is far inside, and all of the ball within their hull.
inline BallSocketPair spike_in_walls(double length, const Eigen::Matrix3d& rotation) {
  BallSocketPair pair{octahedron(5.0), six_walls()};
  pair.ball.vertices[4] = length * tip_direction(kTipTilt);  // that along +z
  for (Vec3& x : pair.ball.vertices) x = rotation.transpose() * x;
  return pair;
}

// The required turn that leads the tip straight towards the normal, radians.
inline RequiredLeg turn_to_wall(double angle, const Eigen::Matrix3d& rotation) {
  RequiredLeg leg;
  leg.turn = {Eigen::Matrix3d::Identity(), tip_direction(kTipTilt).cross(Vec3::UnitZ()).normalized(),
              rotation};
  leg.growing = "flexion";
  leg.largest_deg = angle / kDegree;
  return leg;
}

// A row for each distance from contact, as a share of the radius: judge(rotation, row) counts what is wrong
// and withheld, for rotations drawn at random. What is proven allows for all roundings: nothing may be wrong.
template <class Judge>
std::vector<StabilityCase> cases_near_contact(const StabilityRun& options, const std::string& method,
                                              const Judge& judge) {
  std::mt19937_64 engine(options.seed + 25);
  std::normal_distribution<double> normal;
  std::vector<Eigen::Matrix3d> rotations;
  for (int k = 0; k < (options.quick ? 1 : 20); ++k) {
    Quaternion4 q;
    for (double& x : q) x = normal(engine);
    rotations.push_back(rotation_of(q));
  }
  std::vector<StabilityCase> rows;
  for (const double closeness : {1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    StabilityCase row;
    row.magnitude = closeness;
    row.method = method;
    row.kind = "ours";
    row.condition = 1.0;
    row.threshold = 0.0;
    for (const Eigen::Matrix3d& rotation : rotations) judge(rotation, row);
    row.error_over_condition_u = static_cast<double>(row.wrong);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace impinge::lab

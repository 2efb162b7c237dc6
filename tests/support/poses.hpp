// SPDX-License-Identifier: GPL-3.0-or-later
// Poses to test with.
#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include "gap/pose.hpp"
#include "mesh/triangle_mesh.hpp"
#include "support/random_vector.hpp"

namespace impinge::test {

// Rotations by up to `turn` radians about any axis, with translations of up to `shift` mm in any direction.
inline std::vector<Pose> random_poses(std::size_t count, double turn, double shift, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> share;
  std::vector<Pose> poses(count);
  for (Pose& pose : poses) {
    const Vec3 axis = random_vector(normal, random).normalized();
    pose.rotation = Eigen::AngleAxisd(turn * share(random), axis).toRotationMatrix();
    const Vec3 way = random_vector(normal, random).normalized();
    pose.translation = shift * share(random) * way;
  }
  return poses;
}

// The meshes of one frame, as the pose puts them.
inline TriangleMesh ball_in_socket_frame(TriangleMesh ball, const Pose& pose) {
  for (Vec3& x : ball.vertices) x = to_socket(pose, x);
  return ball;
}

inline TriangleMesh socket_in_ball_frame(TriangleMesh socket, const Pose& pose) {
  for (Vec3& x : socket.vertices) x = to_ball(pose, x);
  return socket;
}

}  // namespace impinge::test

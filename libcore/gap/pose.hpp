// SPDX-License-Identifier: GPL-3.0-or-later
// The pose of the ball in the socket.
#pragma once

#include <Eigen/Core>

#include "sphere/direction.hpp"

namespace impinge {

/// x_socket = rotation x_ball + translation, from the ball's centre frame to the socket's (README.md,
/// Frames).
struct Pose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  // orthogonal, with determinant 1
  Vec3 translation = Vec3::Zero();                         // mm, in the socket's frame
};

/// Takes a point of the ball to the frame of the socket, mm. It is written out because Eigen's product of
/// matrix and vector uses fused multiply-add where a processor has it, so that gaps would depend on the
/// machine.
inline Vec3 to_socket(const Pose& pose, const Vec3& ball_point) {
  const auto& r = pose.rotation;
  return ((r.col(0) * ball_point.x() + r.col(1) * ball_point.y()) + r.col(2) * ball_point.z()) +
         pose.translation;
}

/// The inverse: takes a point of the socket to the frame of the ball, mm.
inline Vec3 to_ball(const Pose& pose, const Vec3& socket_point) {
  const Vec3 x = socket_point - pose.translation;
  const auto& r = pose.rotation;
  return {r.col(0).dot(x), r.col(1).dot(x), r.col(2).dot(x)};
}

}  // namespace impinge

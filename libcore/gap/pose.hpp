// SPDX-License-Identifier: GPL-3.0-or-later
// Where the ball stands in the socket.
#pragma once

#include <Eigen/Core>

#include "sphere/direction.hpp"

namespace impinge {

/// x_socket = rotation x_ball + translation, from the ball's centre frame to the socket's
/// (README.md, Frames). rotation is orthogonal with determinant 1; translation in mm.
struct Pose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  // orthogonal, with determinant 1
  Vec3 translation = Vec3::Zero();                         // mm, in the socket's frame
};

/// A point of the ball, in the frame of the socket, mm. Written out: Eigen's own product of matrix and vector
/// takes fused multiply-add where a processor has it, and a gap would depend on the machine that the library
/// was compiled for.
inline Vec3 to_socket(const Pose& pose, const Vec3& ball_point) {
  const auto& r = pose.rotation;
  return ((r.col(0) * ball_point.x() + r.col(1) * ball_point.y()) + r.col(2) * ball_point.z()) +
         pose.translation;
}

/// The inverse: a point of the socket, in the frame of the ball, mm.
inline Vec3 to_ball(const Pose& pose, const Vec3& socket_point) {
  const Vec3 x = socket_point - pose.translation;
  const auto& r = pose.rotation;
  return {r.col(0).dot(x), r.col(1).dot(x), r.col(2).dot(x)};
}

}  // namespace impinge

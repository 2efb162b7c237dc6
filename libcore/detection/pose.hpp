// SPDX-License-Identifier: GPL-3.0-or-later
// Where the ball stands in the socket.
#pragma once

#include <Eigen/Core>

#include "sphere/direction.hpp"

namespace impinge {

// x_socket = rotation x_ball + translation, from the ball's centre frame to the socket's (see
// sphere/frames.hpp). rotation is orthogonal with determinant 1; translation in mm.
struct Pose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 translation = Vec3::Zero();
};

inline Vec3 to_socket(const Pose& pose, const Vec3& ball_point) {
  return pose.rotation * ball_point + pose.translation;
}

inline Vec3 to_ball(const Pose& pose, const Vec3& socket_point) {
  return pose.rotation.transpose() * (socket_point - pose.translation);
}

}  // namespace impinge

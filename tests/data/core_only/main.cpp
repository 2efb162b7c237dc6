// SPDX-License-Identifier: GPL-3.0-or-later
// When does the cam of the generated joint touch, and how close does it come before? A compiler, Eigen and
// the core of impinge are all that this needs.
#include <cstdio>

#include <Eigen/Geometry>

#include "hip/sphere_fit.hpp"
#include "joint/needed_work.hpp"
#include "mesh/generated_pair.hpp"

int main() {
  using namespace impinge;
  const BallSocketPair joint = make_ball_socket_pair(2000, impinging_cam());
  SceneNeeds needs;
  needs.question = Question::first_contact;
  needs.poses = {Pose{Eigen::AngleAxisd(-0.5, Vec3::UnitY()).toRotationMatrix(), Vec3::Zero()}};
  const AnyScheme scheme("rsid", 0.5);
  const SceneAnswer smallest = answer_by_table(joint, needs, scheme);
  needs.question = Question::touch;
  needs.poses.push_back({Eigen::AngleAxisd(-1.0, Vec3::UnitY()).toRotationMatrix(), Vec3::Zero()});
  const SceneAnswer touch = answer_by_table(joint, needs, scheme);
  std::printf("%.3f %d %d %.3f\n", smallest.smallest->gap_mm, static_cast<int>(touch.touches[0]),
              static_cast<int>(touch.touches[1]), fit_ball(joint.socket).radius);
  return 0;
}

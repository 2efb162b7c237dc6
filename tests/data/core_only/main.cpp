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
  const AnyScheme scheme("rsid", 0.5);
  const auto smallest_gap = [&](double angle) {
    SceneNeeds needs{.question = Question::smallest_gap};
    needs.pose.rotation = Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix();
    return answer_by_table(joint, needs, scheme).smallest->gap_mm;
  };
  const double free = smallest_gap(-0.5);
  std::printf("%.3f %d %d %.3f\n", free, free <= 0.0, smallest_gap(-1.0) <= 0.0,
              fit_ball(joint.socket).radius);
  return 0;
}

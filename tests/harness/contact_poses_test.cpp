// SPDX-License-Identifier: GPL-3.0-or-later
// Poses close to contact, on either side of it.
#include "harness/contact_poses.hpp"

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"

namespace impinge::lab {
namespace {

// Spheres of radius 20 in 26 with a common centre touch once the ball has moved by 6 mm, less the sagittas of
// their faces.
TEST(ContactPoses, FindTheFirstContact) {
  const SurfaceOverlay spheres(sphere(20.0, 4000), sphere(26.0, 4000));
  const auto impinged = [&spheres](const Pose& pose) { return spheres.impinged(pose); };
  PosePath path;
  path.shift = Vec3(0.0, 8.0, 6.0);
  const auto contact = first_contact(path, impinged);
  ASSERT_TRUE(contact);
  EXPECT_NEAR(*contact * 10.0, 6.0, 0.06);
  EXPECT_TRUE(spheres.impinged(path.at(*contact)));
  EXPECT_FALSE(spheres.impinged(path.at(*contact - 0x1p-23)));
  path.shift *= 0.5;
  EXPECT_FALSE(first_contact(path, impinged));
}

TEST(ContactPoses, AreMostlyCloseToContactAndOnBothSides) {
  const BallSocketPair joint = make_ball_socket_pair(100, impinging_cam());
  const SurfaceOverlay overlay(joint.ball, joint.socket);
  const auto poses = contact_poses(overlay, {240, 1.0, 12.0, 3});
  std::size_t close = 0;
  std::size_t impinged = 0;
  std::size_t turns = 0;
  for (const ContactPose& pose : poses) {
    impinged += overlay.impinged(pose.pose) ? 1U : 0U;
    turns += pose.path.shift.isZero() ? 1U : 0U;
    if (!pose.contact) continue;
    const Pose touching = pose.path.at(*pose.contact);
    const double way = (touching.translation - pose.pose.translation).norm() +
                       kArm * (touching.rotation - pose.pose.rotation).norm();
    close += way < 0.5 ? 1U : 0U;
  }
  EXPECT_GT(close, 75U);
  EXPECT_GT(impinged, 45U);
  EXPECT_LT(impinged, 195U);
  EXPECT_GT(turns, 0U);
}

}  // namespace
}  // namespace impinge::lab

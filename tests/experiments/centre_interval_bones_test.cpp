// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of real joints, of which some jump where a graze becomes a contact: the interval holds for random
// centres within half a millimetre of the one that the joint is described with. Needs the folder that
// IMPINGE_BONES names; without it there is nothing to test.
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "harness/real_joints.hpp"
#include "hip/sphere_fit.hpp"
#include "limits/told_limit.hpp"
#include "support/dice.hpp"

namespace impinge::lab {
namespace {

constexpr int kCentres = 6;

struct AskedLimit {
  const char* subject;
  const char* motion;
  bool jumps;  // then no upper end need be known
};

Vec3 random_centre(test::Dice& dice) {
  const Vec3 way = dice.direction();
  return dice.between(0.3, 0.99) * kErrorOfInput * way;
}

TEST(CentreIntervalBones, HoldsForOtherCentres) {
  const char* bones = std::getenv("IMPINGE_BONES");  // NOLINT(concurrency-mt-unsafe)
  if (bones == nullptr) GTEST_SKIP() << "no real joints: set IMPINGE_BONES";
  Progress progress("test", nullptr);
  test::Dice dice(18);
  for (const RealJoint& joint : read_real_joints(bones, progress)) {
    for (const AskedLimit& asked : {AskedLimit{"cargen_left", "internal_rotation", true},
                                    {"libhip_m4_left", "flexion", true},
                                    {"cargen_left", "flexion", false},
                                    {"vsd_z013_right", "abduction", false}}) {
      if (joint.subject != asked.subject) continue;
      const BallSocketPair meshes = in_joint_frame(joint);
      const JointTurn turn = joint_turn({}, motion_name(asked.motion), joint.side);
      const ToldLimit told = told_limit(TurnLimits(meshes), turn, 0.0, 180.0);
      EXPECT_TRUE(!asked.jumps || told.hangs_on_less()) << asked.subject;
      EXPECT_TRUE(asked.jumps || told.common.limited) << asked.subject;
      double least = told.limit.low_deg;
      double most = told.limit.high_deg;
      for (int k = 0; k < kCentres; ++k) {
        // The last is the centre of a sphere fitted to the ball, 0.1 mm away, about which the limit is
        // another.
        const Vec3 at = k + 1 < kCentres ? random_centre(dice) : fit_ball(meshes.ball).centre;
        const TurnLimit limit = TurnLimits({relative_to(meshes.ball, at), relative_to(meshes.socket, at)})
                                    .first_contact(turn, 180.0);
        ASSERT_EQ(limit.state, LimitState::limited);
        least = std::min(least, limit.low_deg);
        most = std::max(most, limit.high_deg);
      }
      EXPECT_TRUE(!asked.jumps || most - least > 20.0) << asked.subject << ": it does not jump";
      EXPECT_LE(told.common.low_deg, least) << asked.subject;
      EXPECT_GE(told.common.high_deg, most) << asked.subject;
    }
  }
}

}  // namespace
}  // namespace impinge::lab

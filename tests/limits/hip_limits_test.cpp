// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of the generated hips: a normal hip reaches what a clinician finds, a cam impinges anterosuperiorly.
// (A left hip is the mirror image of a right one: tests/python/test_motion.py.)
#include <string>

#include <gtest/gtest.h>

#include "hip/clock.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/named_motion.hpp"
#include "limits/turn_limit.hpp"

namespace impinge {
namespace {

constexpr std::size_t kHipFacesHere = 800;

struct HipLimits {
  explicit HipLimits(const HipParameters& parameters)
      : HipLimits(parameters, make_hip(parameters, kHipFacesHere)) {}
  HipLimits(const HipParameters& parameters, const Hip& hip)
      : side(parameters.side), dial(*clock_face(hip.socket)), limits({hip.ball, hip.socket}) {}

  TurnLimit of(std::string_view name) const {
    for (const NamedMotion& motion : named_motions()) {
      if (motion.name != name) continue;
      const MotionName& growing = motion_name(motion.growing);
      return limits.first_contact(joint_turn(motion.start, growing, side),
                                  largest_growth(motion.start, growing));
    }
    ADD_FAILURE() << "no motion " << name;
    return {};
  }

  Side side;
  ClockFace dial;
  TurnLimits limits;
};

// Bone alone: soft tissue stops a patient before. Degrees: from what normal hips reach to 10 degrees or so
// above what these shapes came to, so that a contact that is missed shows.
TEST(HipLimits, ANormalHipReachesTheClinicalRanges) {
  const HipLimits normal(hip_preset("normal"));
  const auto expect_within = [&](std::string_view motion, double least, double most) {
    const TurnLimit limit = normal.of(motion);
    EXPECT_EQ(limit.state, LimitState::limited) << motion;
    EXPECT_GT(limit.low_deg, least) << motion;
    EXPECT_LT(limit.high_deg, most) << motion << ": it is no ball on a thread";
  };
  expect_within("flexion", 110.0, 158.0);
  expect_within("extension", 10.0, 77.0);
  expect_within("abduction", 30.0, 69.0);
  expect_within("adduction", 20.0, 64.0);
  expect_within("external_rotation", 40.0, 57.0);
  expect_within("internal_rotation_at_90", 30.0, 51.0);
}

// Between 12 and 3 o'clock, with some tolerance at 12, and earlier than a normal hip.
TEST(HipLimits, CamsImpingeAnterosuperiorlyInFadir) {
  const double normal = HipLimits(hip_preset("normal")).of("fadir").low_deg;
  for (const char* name : {"cam", "mixed"}) {
    const HipLimits hip(hip_preset(name));
    const TurnLimit limit = hip.of("fadir");
    ASSERT_EQ(limit.state, LimitState::limited) << name;
    const double hours = hip.dial.hours(limit.contact->place);
    EXPECT_TRUE(hours < 3.0 || hours > 11.75) << name << " " << clock_text(hours);
    EXPECT_LT(limit.high_deg, normal - 5.0) << name;
  }
}

TEST(NamedMotion, EachCanBeDone) {
  for (const NamedMotion& motion : named_motions()) {
    const MotionName& growing = motion_name(motion.growing);
    EXPECT_GT(largest_growth(motion.start, growing), 90.0) << motion.name;
    EXPECT_NO_THROW(joint_turn(motion.start, growing, Side::left)) << motion.name;
    EXPECT_FALSE(motion.meaning.empty());
  }
}

}  // namespace
}  // namespace impinge

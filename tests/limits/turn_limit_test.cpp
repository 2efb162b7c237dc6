// SPDX-License-Identifier: GPL-3.0-or-later
// low: no pose from the start is impinged; high: this one is; high - low below a tenth of a degree.
#include "limits/turn_limit.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"

namespace impinge {
namespace {

constexpr double kWidest = 0.1;  // degrees
const JointTurn kAbduct = joint_turn({}, motion_name("abduction"), Side::right);

// The pair with its bump as high as the space: the smooth ball reaches the smooth socket once the part of the
// bump above 4 mm, 8.86 degrees about its top at 130, is under the rim at 87: a turn of 34.14 degrees. The
// meshes are a tenth of a millimetre within, which is a degree.
TEST(TurnLimit, OfTheCamIsThatOfItsFormula) {
  const TurnLimits limits(make_ball_socket_pair(1600, impinging_cam()));
  const TurnLimit limit = limits.first_contact(kAbduct, 120.0);
  EXPECT_EQ(limit.state, LimitState::reached);
  const double level = 60.0 / kPi * std::acos(std::sqrt(0.8));  // degrees from the top
  EXPECT_NEAR(limit.low_deg, 130.0 - 87.0 - level, 1.5);
  EXPECT_LE(limit.high_deg - limit.low_deg, kWidest);
  EXPECT_FALSE(limits.impinged(kAbduct, limit.low_deg));
  EXPECT_TRUE(limits.impinged(kAbduct, limit.high_deg));
  EXPECT_GT(limits.smallest_gap(kAbduct, limit.low_deg)->gap_mm, -1e-9);
}

TEST(TurnLimit, SaysWhenThereIsNone) {
  const TurnLimits limits(make_ball_socket_pair(400));
  const TurnLimit limit = limits.first_contact(kAbduct, 150.0);
  EXPECT_EQ(limit.state, LimitState::free);
  EXPECT_EQ(limit.low_deg, 150.0);
  EXPECT_EQ(limit.high_deg, 150.0);
  EXPECT_FALSE(limit.contact);
  EXPECT_THROW(limits.first_contact(kAbduct, 0.0), std::invalid_argument);
  EXPECT_THROW(limits.first_contact(kAbduct, 361.0), std::invalid_argument);
}

TEST(TurnLimit, SaysWhenTheStartIsBlocked) {
  const TurnLimits limits({octahedron(30.0), octahedron(29.0)});
  EXPECT_EQ(limits.first_contact(kAbduct, 90.0).state, LimitState::blocked);
  const TurnLimits wide({octahedron(20.0), octahedron(29.0)});
  EXPECT_EQ(wide.gap_of(kAbduct, 9.5, 10.0).state, LimitState::blocked);
  EXPECT_EQ(wide.gap_of(kAbduct, 8.5, 10.0).state, LimitState::reached);
}

// A gap falls to a threshold before the surfaces touch, and to a smaller one later.
TEST(TurnLimit, OfAThresholdComesBeforeContact) {
  const TurnLimits limits(make_ball_socket_pair(1000, impinging_cam()));
  double later = limits.first_contact(kAbduct, 120.0).low_deg;
  for (const double gap : {0.5, 1.0, 2.0}) {
    const TurnLimit limit = limits.gap_of(kAbduct, gap, 120.0);
    ASSERT_EQ(limit.state, LimitState::reached);
    EXPECT_LT(limit.high_deg, later);
    EXPECT_LE(limit.high_deg - limit.low_deg, kWidest);
    EXPECT_GT(limits.smallest_gap(kAbduct, limit.low_deg - 1e-6)->gap_mm, gap);
    EXPECT_LE(limits.smallest_gap(kAbduct, limit.high_deg)->gap_mm, gap);
    later = limit.high_deg;
  }
}

// What the limit moves by when the socket moves across the contact: as `deg_per_mm` says, to first order.
TEST(TurnLimit, SensitivityIsThatOfAShiftedCentre) {
  const BallSocketPair joint = make_ball_socket_pair(1000, impinging_cam());
  const TurnLimit limit = TurnLimits(joint).first_contact(kAbduct, 120.0);
  constexpr double kShift = 1e-4;  // mm
  for (const double way : {-kShift, kShift}) {
    BallSocketPair moved = joint;
    for (Vec3& x : moved.socket.vertices) x += way * limit.contact->normal;
    const TurnLimit other = TurnLimits(moved).first_contact(kAbduct, 120.0);
    EXPECT_NEAR(std::abs(other.low_deg - limit.low_deg), limit.deg_per_mm * kShift,
                0.01 * limit.deg_per_mm * kShift);
  }
}

// A pose goes through outer, axis and inner turns alike: the same limit from wherever the motion begins.
TEST(TurnLimit, CountsFromWhereTheMotionBegins) {
  const TurnLimits limits(make_ball_socket_pair(600, impinging_cam()));
  const double whole = limits.first_contact(kAbduct, 120.0).low_deg;
  const JointTurn later = joint_turn(parse_motion("abduction=10"), motion_name("abduction"), Side::right);
  EXPECT_NEAR(limits.first_contact(later, 120.0).low_deg, whole - 10.0, 1e-6);
  const JointTurn bent =
      joint_turn(parse_motion("flexion=30,internal_rotation=20"), motion_name("abduction"), Side::right);
  const TurnLimit limit = limits.first_contact(bent, 120.0);
  ASSERT_EQ(limit.state, LimitState::reached);
  EXPECT_FALSE(limits.impinged(bent, limit.low_deg));
  EXPECT_TRUE(limits.impinged(bent, limit.high_deg));
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Random cases of what made a limit false: faces that slide in one plane, grazes with a contact behind them,
// thresholds with jump edges of the socket next to the centre or beyond the distance of a vertex, and loose
// triangles. Surfaces meet in no pose up to low and in the pose at high, and free is said of no motion in
// which they meet.
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limits/turn_limit.hpp"
#include "limits/turn_oracle.hpp"
#include "support/dice.hpp"
#include "support/joined.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

using test::add_face;
using test::Dice;

Vec3 at(double radius, double azimuth, double z) {
  return {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
}

struct Case {
  BallSocketPair joint;
  JointTurn motion{Eigen::Matrix3d::Identity(), Vec3::UnitZ(), Eigen::Matrix3d::Identity()};
  double largest = 170.0;

  void turn(const Eigen::Matrix3d& rotation) {
    for (Vec3& x : joint.ball.vertices) x = rotation * x;
    for (Vec3& x : joint.socket.vertices) x = rotation * x;
    motion.axis = rotation * motion.axis;
  }
};

// Angles up to low: everywhere, and next to it.
std::vector<double> angles_up_to(double low, Dice& random) {
  std::vector<double> angles{low, std::max(0.0, low - 1e-6)};
  for (int k = 0; k < 6; ++k) angles.push_back(low * random.between(0.0, 1.0));
  for (int k = 0; k < 2; ++k) angles.push_back(low * (1.0 - random.power(-6.0, -1.0)));
  return angles;
}

// The limit of the case, held against the oracle.
TurnLimit checked(const Case& given, Dice& random, std::size_t number) {
  const TurnLimits limits(given.joint);
  const TurnLimit limit = limits.first_contact(given.motion, given.largest);
  const test::TurnOracle oracle(given.joint, given.motion.axis);
  if (limit.state == LimitState::blocked) {
    EXPECT_TRUE(oracle.perhaps_meets(0.0) || limits.verdict(given.motion, 0.0).rule == ContactRule::radii)
        << number;
    return limit;
  }
  EXPECT_FALSE(oracle.surely_meets(0.0)) << number;
  for (const double angle : angles_up_to(limit.low_deg, random))
    EXPECT_FALSE(oracle.surely_meets(angle)) << number << " at " << angle << " of " << limit.low_deg;
  if (limit.state == LimitState::limited) {
    EXPECT_TRUE(oracle.perhaps_meets(limit.high_deg)) << number << " at " << limit.high_deg;
  }
  return limit;
}

// The limit of a threshold, likewise.
TurnLimit checked_gap(const Case& given, double gap, long double margin, Dice& random, std::size_t number) {
  const TurnLimits limits(given.joint);
  const TurnLimit limit = limits.gap_of(given.motion, gap, given.largest);
  const test::TurnOracle oracle(given.joint, given.motion.axis);
  constexpr long double kDepth = test::TurnOracle::kDepth;
  EXPECT_NE(limit.state, LimitState::blocked) << number;
  for (const double angle : angles_up_to(limit.low_deg, random)) {
    EXPECT_GT(oracle.smallest_gap(angle, margin), gap - kDepth) << number << " at " << angle;
    EXPECT_FALSE(oracle.surely_meets(angle)) << number << " at " << angle;
  }
  if (limit.state == LimitState::limited) {
    EXPECT_LT(limit.high_deg - limit.low_deg, 1e-4) << number;
    EXPECT_TRUE(oracle.smallest_gap(limit.high_deg, -margin) <= gap + kDepth ||
                oracle.perhaps_meets(limit.high_deg))
        << number;
  }
  return limit;
}

// Where a graze lasts, poses are asked for one by one, some milliseconds a case: four tests have a twentieth
// of the cases each.
class TheoremTurnOfALongGraze : public testing::TestWithParam<unsigned> {};

INSTANTIATE_TEST_SUITE_P(Quarters, TheoremTurnOfALongGraze, testing::Range(0U, 4U));

// Faces of both slide over each other in one plane; a wall that stands across it comes later in the way.
TEST_P(TheoremTurnOfALongGraze, OfFacesThatSlideInOnePlane) {
  Dice random(10 + GetParam());
  for (std::size_t k = 0; k < random_cases() / 20; ++k) {
    Case given;
    const double z = random.between(1.0, 3.0);
    add_face(given.joint.ball, {4, 0, z}, {3.5, -1, z}, {2.6, -1, z});
    add_face(given.joint.socket, {2, 3, z}, {2, 4, z}, {-1, 3.5, z});
    const double from = random.between(130.0, 150.0) * kDegree;
    const double to = from + random.between(3.0, 10.0) * kDegree;
    add_face(given.joint.socket, at(3, from, 0.6 * z), at(3, to, 0.6 * z), at(3, from, 1.6 * z));
    given.turn(random.rotation());
    const TurnLimit limit = checked(given, random, k);
    ASSERT_EQ(limit.state, LimitState::limited) << k;
    ASSERT_LT(limit.high_deg, to / kDegree + 20.0) << k;  // the side of the face that leads is at -15.3 there
    ASSERT_FALSE(HasFailure()) << k;
  }
}

// A corner at 25 mm passes another within some billionths, or meets it; right behind it, or farther, is a
// pair of small faces that it runs into.
TEST_P(TheoremTurnOfALongGraze, OfAGrazeBeforeAContact) {
  Dice random(20 + GetParam());
  for (std::size_t k = 0; k < random_cases() / 20; ++k) {
    Case given;
    const double passes = random.between(20.0, 90.0) * kDegree;
    const double width = random.power(-3.5, -2.0);
    const double behind = passes + random.power(-3.7, -0.5);
    const double tip = 25.0 + (random.between(0.0, 1.0) < 0.8 ? 1.0 : -1.0) * random.power(-13.0, -6.0);
    add_face(given.joint.ball, at(25, 0, 0), at(25, -1e-4, 1e-3), at(25, -1e-4, -1e-3));
    add_face(given.joint.socket, at(tip, passes, 0), at(27, passes + 1e-5, 1), at(27, passes + 1e-5, -1));
    for (const double z : {3.0, -3.0})
      add_face(given.joint.socket, at(24, behind, z), at(24, behind + width, -z),
               at(27, behind + 0.5 * width, 0.1 * z));
    given.largest = (behind + 0.5) / kDegree;
    given.turn(random.rotation());
    const TurnLimit limit = checked(given, random, k);
    ASSERT_EQ(limit.state, LimitState::limited) << k;
    ASSERT_LT(limit.high_deg, (behind + width) / kDegree) << k;
    ASSERT_FALSE(HasFailure()) << k;
  }
}

// A side of the socket that passes the centre at h, and a small face of the ball beyond it that turns into
// the view of it: there its gap is far below every threshold, and nothing meets.
TEST(TheoremTurn, OfAThresholdAtAJumpEdgeNextToTheCentre) {
  Dice random(3);
  for (std::size_t k = 0; k < random_cases() / 5; ++k) {
    Case given;
    const double h = random.power(-6.0, 0.0);
    const double long_way = random.power(-0.5, 1.5);
    const double tilt = random.between(-0.5, 0.5) * h;
    add_face(given.joint.socket, {h, -long_way, h + tilt}, {h, long_way, h}, {8, 0, h});
    const double y = random.between(-0.5, 0.5);
    add_face(given.joint.ball, {4, y - 0.5, 25}, {4, y + 0.5, 25}, {5, y, 25});
    given.motion.axis = Vec3::UnitY();
    given.largest = 60.0;
    given.turn(random.rotation());
    // What rounding of its ends does to the side's direction.
    const long double margin = 1e-11L + 1e-14L * long_way / h;
    const TurnLimit limit = checked_gap(given, random.between(0.0, 8.0), margin, random, k);
    ASSERT_EQ(limit.state, LimitState::limited) << k << " " << h;
    ASSERT_EQ(TurnLimits(given.joint).first_contact(given.motion, given.largest).state, LimitState::free)
        << k;
    ASSERT_FALSE(HasFailure()) << k << " " << h;
  }
}

// A patch of the ball that turns over a small face of the socket, at distances below the threshold and above.
TEST(TheoremTurn, OfAThresholdBeyondAVertex) {
  Dice random(4);
  std::size_t limited = 0;
  for (std::size_t k = 0; k < random_cases(); ++k) {
    Case given;
    const double gap = random.between(0.5, 8.0);
    const double r = random.between(0.3, 3.0);
    const double out = r + random.between(0.2, 4.0);
    const double at_z = random.between(-0.5, 0.5);
    add_face(given.joint.ball, at(r, 0, 2.0 * r), at(0.6 * r, 0.7, -0.3 * r), at(0.6 * r, -0.7, -0.3 * r));
    add_face(given.joint.socket, at(out, 1.4, at_z), at(out, 1.45, at_z), at(out, 1.42, at_z + 0.1));
    given.largest = 120.0;
    given.turn(random.rotation());
    const TurnLimit limit = checked_gap(given, gap, test::TurnOracle::kMargin, random, k);
    ASSERT_FALSE(HasFailure()) << k;
    limited += limit.state == LimitState::limited ? 1 : 0;
  }
  EXPECT_GT(limited, random_cases() / 4);
}

TEST(TheoremTurn, OfLooseTriangles) {
  Dice random(5);
  std::size_t limited = 0;
  const std::size_t cases = random_cases() / 2;
  for (std::size_t k = 0; k < cases; ++k) {
    Case given;
    for (int f = 0; f < 2; ++f) {
      for (TriangleMesh* mesh : {&given.joint.ball, &given.joint.socket}) {
        const Vec3 middle = random.rotation() * Vec3(0, 0, random.between(2.0, 25.0));
        const double size = random.power(0.3, 1.5);
        const auto corner = [&] { return Vec3(middle + random.rotation() * Vec3(0, 0, size)); };
        add_face(*mesh, corner(), corner(), corner());
      }
    }
    given.motion.axis = random.rotation() * Vec3::UnitX();
    const TurnLimit limit = checked(given, random, k);
    limited += limit.state == LimitState::limited ? 1 : 0;
    if (limit.state == LimitState::limited) {
      ASSERT_LT(limit.high_deg - limit.low_deg, 1e-3) << k;
    }
    ASSERT_FALSE(HasFailure()) << k;
  }
  EXPECT_GT(limited, cases / 10);
}

}  // namespace
}  // namespace impinge

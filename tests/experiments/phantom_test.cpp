// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of the phantoms are within a hundredth of a degree of their closed forms, gaps within what is
// proven.
#include "phantoms/phantom.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "hip/motion.hpp"
#include "limits/turn_limit.hpp"
#include "phantoms/phantom.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

TEST(Phantom, FirstTurnToAnAngleIsTheFirst) {
  const auto v = test::random_directions(30, 9);
  int found = 0;
  for (std::size_t i = 0; i + 2 < v.size(); i += 3) {
    const AngleQuestion question{v[i], v[i + 1], v[i + 2], 0.3};
    const auto off = [&](double t) {
      return (Eigen::AngleAxisd(t, question.axis) * question.turning).dot(question.fixed) - question.cosine;
    };
    const auto first = first_turn_to(question);
    const double end = first ? *first : 2.0 * kPi;
    for (int k = 1; k < 500; ++k) EXPECT_GT(off(1e-9) * off(end * k / 500.0), 0.0);
    if (!first) continue;
    ++found;
    EXPECT_NEAR(off(*first), 0.0, 1e-12);
  }
  EXPECT_GT(found, 3);
}

// Worst seen: 0.0056.
TEST(Phantom, LimitsAreWithinAHundredthOfADegree) {
  const auto rows = phantom_limits({});
  EXPECT_EQ(rows.size(), 11U);
  for (const PhantomRow& row : rows) {
    EXPECT_LE(std::abs(row.error), kPhantomLimitError) << row.phantom << ", " << row.quantity;
    EXPECT_FALSE(row.proven);
  }
}

TEST(Phantom, GapsAreWithinTheirBounds) {
  const auto rows = phantom_gaps({40, 400, 4.0});  // coarse, for the time it takes
  EXPECT_EQ(rows.size(), 9U);
  for (const PhantomRow& row : rows) {
    EXPECT_LE(std::abs(row.error), row.allowed) << row.phantom << ", " << row.quantity;
    EXPECT_LT(row.allowed, 2.0) << "a bound that says something";
  }
}

// The neck, 6 mm from its axis, meets the rim of the cup, 16.1 mm from the centre and square to its opening.
TEST(Phantom, AnImplantTurnsUntilItsNeckMeetsTheRim) {
  const auto outwards = [](double forward_deg) {
    const double forward = forward_deg * kDegree;
    return Vec3(std::cos(forward), std::sin(forward), -1.0).normalized();
  };
  const TurnLimits limits(make_implant(40000));
  for (const char* motion : {"flexion", "extension", "abduction", "adduction"}) {
    const JointTurn turn = joint_turn({}, motion_name(motion), Side::right);
    const auto expected = first_turn_to(
        {outwards(10.0), outwards(20.0), turn.axis, std::cos(0.5 * kPi - std::asin(6.0 / 16.1))});
    ASSERT_TRUE(expected);
    EXPECT_NEAR(limits.first_contact(turn, 180.0).high_deg, *expected / kDegree, 0.5) << motion;
  }
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Cosine and sine of 2 pi t, and hav a = (1 - cos a) / 2, against long double.
#include "sphere/turn_angle.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "sphere/haversine.hpp"

namespace impinge {
namespace {

TEST(TurnAngle, IsCosineAndSine) {
  std::mt19937_64 random(70);
  for (const double size : {1e-9, 0.2, 1.0, 1e6}) {
    std::uniform_real_distribution<double> turns(-size, size);
    for (int k = 0; k < 20000; ++k) {
      const double t = turns(random);
      const long double angle = 2.0L * std::numbers::pi_v<long double> * (t - std::round(t));
      const CosSin found = turn_angle(t);
      ASSERT_NEAR(found.cos, static_cast<double>(std::cos(angle)), 3e-16) << t;
      ASSERT_NEAR(found.sin, static_cast<double>(std::sin(angle)), 3e-16) << t;
    }
  }
}

TEST(TurnAngle, QuarterTurnsAreExact) {
  for (int quarter = -9; quarter <= 9; ++quarter) {
    const CosSin expected = half_turn_fraction(quarter, 2);
    const CosSin found = turn_angle(0.25 * quarter);
    EXPECT_EQ(found.cos, expected.cos) << quarter;
    EXPECT_EQ(found.sin, expected.sin) << quarter;
  }
}

TEST(Haversine, IsTheSquareOfTheHalfAnglesSine) {
  std::mt19937_64 random(71);
  std::uniform_real_distribution<double> exponent(-60.0, 0.0);
  for (int k = 0; k < 20000; ++k) {
    const double angle = k % 2 == 0 ? kPi * std::exp2(exponent(random)) : kPi * k / 20000.0;
    const long double sine = std::sin(0.5L * static_cast<long double>(angle));
    const auto expected = static_cast<double>(sine * sine);
    ASSERT_NEAR(haversine(angle), expected, 4e-16 * (angle < 0.5 * kPi ? expected : 1.0)) << angle;
  }
  EXPECT_EQ(haversine(0.0), 0.0);
  EXPECT_EQ(haversine(kPi), 1.0);
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// x = d sin(phi) cos(theta), y = d sin(phi) sin(theta), z = d cos(phi)        (thesis, Eq. 5)
#include "sphere/direction.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/directions.hpp"

namespace impinge {
namespace {

TEST(Direction, AnglesAndBack) {
  for (const Vec3& u : test::random_directions(10000, 1)) {
    EXPECT_LT((to_direction(to_angles(7.5 * u)) - u).norm(), 1e-15 * 4);
  }
}

TEST(Direction, AnglesStayInRange) {
  for (const Vec3& x : test::special_directions()) {
    const auto [phi, theta] = to_angles(x);
    EXPECT_GE(phi, 0.0);
    EXPECT_LE(phi, kPi);
    EXPECT_GE(theta, 0.0);
    EXPECT_LT(theta, 2.0 * kPi);
    EXPECT_FALSE(std::signbit(theta)) << x.transpose();
  }
}

// The arccosine of Eq. 6 gives 0 for every phi below 1e-8.
TEST(Direction, PolarAngleKeepsItsDigitsAtThePole) {
  for (const double phi : {1e-3, 1e-6, 1e-9, 1e-12, 1e-16}) {
    EXPECT_DOUBLE_EQ(to_angles({std::sin(phi), 0.0, std::cos(phi)}).phi, phi);
    EXPECT_DOUBLE_EQ(angle_between({std::sin(phi), 0.0, std::cos(phi)}, {0.0, 0.0, 1.0}), phi);
  }
}

TEST(Direction, AzimuthOfAPoleIsZero) {
  EXPECT_EQ(to_angles({0.0, 0.0, 2.0}).theta, 0.0);
  EXPECT_EQ(to_angles({0.0, 0.0, -2.0}).theta, 0.0);
  EXPECT_EQ(to_angles({0.0, 0.0, -2.0}).phi, kPi);
}

TEST(HalfTurnFraction, EqualsTheLibraryFunctions) {
  for (const long n : {1L, 2L, 3L, 7L, 180L, 3600L}) {
    for (long k = -2 * n; k <= 4 * n; ++k) {
      const double angle = kPi * static_cast<double>(k) / static_cast<double>(n);
      EXPECT_NEAR(half_turn_fraction(k, n).cos, std::cos(angle), 3e-15);
      EXPECT_NEAR(half_turn_fraction(k, n).sin, std::sin(angle), 3e-15);
    }
  }
}

TEST(HalfTurnFraction, QuartersAreExactAndSymmetriesHoldBitForBit) {
  for (const long n : {2L, 180L, 3600L}) {
    EXPECT_EQ(half_turn_fraction(n / 2, n).cos, 0.0);
    EXPECT_EQ(half_turn_fraction(n / 2, n).sin, 1.0);
    EXPECT_EQ(half_turn_fraction(n, n).cos, -1.0);
    EXPECT_EQ(half_turn_fraction(n, n).sin, 0.0);
    EXPECT_EQ(half_turn_fraction(3 * n / 2, n).sin, -1.0);
    for (long k = 0; k <= n; ++k) {
      EXPECT_EQ(half_turn_fraction(k, n).cos, -half_turn_fraction(n - k, n).cos);
      EXPECT_EQ(half_turn_fraction(k, n).sin, half_turn_fraction(n - k, n).sin);
      EXPECT_EQ(half_turn_fraction(k, n).sin, -half_turn_fraction(-k, n).sin);
    }
  }
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// x = d sin(phi) cos(theta), y = d sin(phi) sin(theta), z = d cos(phi)        (thesis, Eq. 5)
#include "sphere/direction.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "sphere/elliptic.hpp"
#include "sphere/elliptic_arc.hpp"
#include "sphere/haversine.hpp"
#include "sphere/smooth_table.hpp"
#include "sphere/turn_angle.hpp"
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

// Cosine and sine of 2 pi t, and hav a = (1 - cos a) / 2, against long double.

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

// The tables made of elliptic integrals against the integrals, which tests/curves holds against GSL.

constexpr std::array kComplements{1e-16, 1e-6, 0.0048, 0.3, 1.0, 2.0, 209.0, 209765.0, 8.4e7, 4e16};

TEST(EllipticArc, LengthAndAngleAreThoseOfTheIntegral) {
  for (const double complement : kComplements) {
    for (const double end : {0.25 * kPi, 0.5 * kPi}) {
      if (complement < 1.0 && end > 0.25 * kPi) continue;
      const EllipticArc arc(complement, end);
      EXPECT_EQ(arc.length(0.0), 0.0);
      EXPECT_EQ(arc.angle(0.0), 0.0);
      for (double x = end; x > 1e-12; x *= 0.83) {
        const double length = elliptic_e(x, complement);
        EXPECT_NEAR(arc.length(x), length, 2e-15 * length) << complement << ' ' << x;
        EXPECT_NEAR(arc.angle(length), x, 2e-15 * x) << complement << ' ' << x;
      }
    }
  }
}

// A table of a function is as good as the function.

void expect_as_good(const std::function<double(double)>& f, double end) {
  const SmoothTable table(f, end);
  for (double x = end; x > 1e-15 * end; x *= 0.97) EXPECT_NEAR(table(x), f(x), 2e-15 * f(x)) << x;
}

TEST(SmoothTable, MeetsEntireFunctions) {
  expect_as_good([](double) { return 3.0; }, 2.0);
  expect_as_good([](double x) { return 1.0 + x * x; }, 1e-3);
  expect_as_good([](double x) { return std::exp(x); }, 5.0);
}

// With a singularity at -end / 10^9, over nine orders of magnitude.
TEST(SmoothTable, FollowsAFunctionThatChangesFastNearZero) {
  for (const double end : {1e-6, 1.0, 1e6}) {
    expect_as_good([end](double x) { return std::sqrt(x / end + 1e-9); }, end);
    expect_as_good([end](double x) { return 1.0 / (x / end + 1e-9); }, end);
    expect_as_good([end](double x) { return std::hypot(x / end, 1e-9); }, end);
  }
}

}  // namespace
}  // namespace impinge

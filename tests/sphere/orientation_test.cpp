// SPDX-License-Identifier: GPL-3.0-or-later
// orientation(a, b, c) = sign of det(a, b, c), checked against integers small enough for exact arithmetic.
#include "sphere/orientation.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "support/directions.hpp"

namespace impinge {
namespace {

__extension__ typedef __int128 Wide;

int exact_sign(const std::array<std::array<long, 3>, 3>& m) {
  const auto minor = [&m](std::size_t i, std::size_t j) {
    return Wide{m[1][i]} * m[2][j] - Wide{m[1][j]} * m[2][i];
  };
  const Wide det = m[0][0] * minor(1, 2) + m[0][1] * minor(2, 0) + m[0][2] * minor(0, 1);
  return det > 0 ? 1 : det < 0 ? -1 : 0;
}

// Integers of 40 bits: products of three need 120, far beyond a double. c = s a + t b + a last digit, so the
// determinant is tiny beside its terms and the floating-point filter cannot decide.
TEST(Orientation, DecidesNearlyCoplanarVectorsExactly) {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<long> digit(-1, 1);
  std::uniform_int_distribution<long> small(-500, 500);
  std::uniform_int_distribution<long> large(-(1L << 28), 1L << 28);
  std::array<int, 3> seen{};
  for (int k = 0; k < 20000; ++k) {
    std::array<std::array<long, 3>, 3> m{};
    const long s = small(random);
    const long t = small(random);
    std::array<Vec3, 3> v;
    for (std::size_t i = 0; i < 3; ++i) {
      m[0][i] = large(random);
      m[1][i] = large(random);
      m[2][i] = s * m[0][i] + t * m[1][i] + digit(random);
      for (std::size_t row = 0; row < 3; ++row)
        v[row][static_cast<Eigen::Index>(i)] = static_cast<double>(m[row][i]);
    }
    const int expected = exact_sign(m);
    ++seen[static_cast<std::size_t>(expected + 1)];
    ASSERT_EQ(orientation(v[0], v[1], v[2]), expected);
    ASSERT_EQ(orientation(v[1], v[0], v[2]), -expected);
    ASSERT_EQ(orientation(v[2], v[0], v[1]), expected);
  }
  EXPECT_GT(seen[0], 100);
  EXPECT_GT(seen[1], 100);  // exactly coplanar ones are among them
  EXPECT_GT(seen[2], 100);
}

// det(c a, b, c) has the sign of det(a, b, c) for every positive scale, from the smallest to the largest
// length.
TEST(Orientation, DoesNotDependOnLength) {
  const auto u = test::random_directions(300, 2);
  for (std::size_t k = 0; k + 2 < u.size(); k += 3) {
    const int sign = orientation(u[k], u[k + 1], u[k + 2]);
    ASSERT_NE(sign, 0);
    for (const int exponent : {-1000, -500, -100, 100, 500, 1000}) {
      const double scale = std::ldexp(1.0, exponent);
      EXPECT_EQ(orientation(scale * u[k], scale * u[k + 1], scale * u[k + 2]), sign) << exponent;
    }
  }
}

TEST(Orientation, TellsNeighbouringDoublesApart) {
  const Vec3 a(1.0, 0.1, 0.2);
  const Vec3 b(0.3, 1.0, 0.7);
  const Vec3 on = a + b;  // rounded, so not exactly in the plane; its neighbours straddle it
  Vec3 below = on;
  Vec3 above = on;
  for (int k = 0; k < 4; ++k) {
    below.z() = std::nextafter(below.z(), -1.0);
    above.z() = std::nextafter(above.z(), 9.0);
  }
  EXPECT_EQ(orientation(a, b, above) - orientation(a, b, below), 2);
  EXPECT_EQ(orientation(a, b, 2.0 * a), 0);
  EXPECT_EQ(orientation(a, b, Vec3::Zero()), 0);
}

}  // namespace
}  // namespace impinge

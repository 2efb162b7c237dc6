// SPDX-License-Identifier: GPL-3.0-or-later
// orientation(a, b, c) = sign of det(a, b, c), checked against integers small enough for exact arithmetic.
#include "sphere/orientation.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sphere/plane_side.hpp"
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
TEST(TheoremSigns, DecidesNearlyCoplanarVectorsExactly) {
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
    for (const int exponent : {-1000, -500, -100, 100, 334, 500, 1000}) {
      const double scale = std::ldexp(1.0, exponent);
      EXPECT_EQ(orientation(scale * u[k], scale * u[k + 1], scale * u[k + 2]), sign) << exponent;
    }
  }
}

TEST(TheoremSigns, TellsNeighbouringDoublesApart) {
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

// Sign of det(b - a, c - a, d - a), against integers of 128 bits.

__extension__ using Wide = __int128;
using Point = std::array<long, 3>;

Vec3 to_vector(const Point& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

int exact_sign(const std::array<Point, 4>& p) {
  std::array<std::array<Wide, 3>, 3> m{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t i = 0; i < 3; ++i) m[row][i] = Wide{p[row + 1][i]} - Wide{p[0][i]};
  }
  Wide det = 0;
  for (std::size_t i = 0; i < 3; ++i)
    det += m[0][i] * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3]);
  return det > 0 ? 1 : det < 0 ? -1 : 0;
}

// d = a + s (b - a) + t (c - a), moved by at most one unit: coplanar or nearly so.
TEST(TheoremSigns, DecidesNearlyCoplanarPointsExactly) {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<long> digit(-1, 1);
  std::uniform_int_distribution<long> small(-200, 200);
  std::uniform_int_distribution<long> large(-(1L << 28), 1L << 28);
  std::array<int, 3> seen{};
  for (int k = 0; k < 20000; ++k) {
    std::array<Point, 4> p{};
    const long s = small(random);
    const long t = small(random);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t row = 0; row < 3; ++row) p[row][i] = large(random);
      p[3][i] =
          p[0][i] + s * (p[1][i] - p[0][i]) + t * (p[2][i] - p[0][i]) + (k % 3 == 0 ? 0 : digit(random));
    }
    const int expected = exact_sign(p);
    ++seen[static_cast<std::size_t>(expected + 1)];
    const std::array<Vec3, 4> x{to_vector(p[0]), to_vector(p[1]), to_vector(p[2]), to_vector(p[3])};
    ASSERT_EQ(plane_side(x[0], x[1], x[2], x[3]), expected);
    ASSERT_EQ(plane_side(x[1], x[0], x[2], x[3]), -expected);
    ASSERT_EQ(plane_side(x[1], x[2], x[3], x[0]), -expected);  // a turn of four is odd
    ASSERT_EQ(plane_side(0x1p-40 * x[0], 0x1p-40 * x[1], 0x1p-40 * x[2], 0x1p-40 * x[3]), expected);
  }
  for (const int count : seen) EXPECT_GT(count, 100);
}

// Products of three lengths below the least and above the largest double, and the error bound of a filter
// below the least normal one.
TEST(TheoremSigns, OfAPlaneAreThoseOfAnyUnit) {
  const std::array<Vec3, 4> x{Vec3(3, 1, 2), Vec3(-2, 4, 1), Vec3(1, -3, 5), Vec3(2, 2, 3)};
  const std::array<Vec3, 4> flat{Vec3(3, 1, 2), Vec3(-2, 4, 1), Vec3(1, -3, 5), Vec3(-4, 0, 4)};
  const int expected = plane_side(x[0], x[1], x[2], x[3]);
  EXPECT_NE(expected, 0);
  for (int exponent = -500; exponent <= 500; exponent += 10) {
    const double unit = std::ldexp(1.0, exponent);
    const auto side = [unit](const std::array<Vec3, 4>& of) {
      return plane_side(unit * of[0], unit * of[1], unit * of[2], unit * of[3]);
    };
    EXPECT_EQ(side(x), expected) << exponent;
    EXPECT_EQ(side(flat), 0) << exponent;
  }
}

TEST(PlaneSide, OfTheCentreIsTheOppositeOfTheOrientation) {
  const auto u = test::random_directions(300, 3);
  for (std::size_t k = 0; k + 2 < u.size(); k += 3) {
    const int side = orientation(u[k], u[k + 1], u[k + 2]);
    EXPECT_EQ(plane_side(u[k], u[k + 1], u[k + 2], Vec3::Zero()), -side);
    const Vec3 middle = u[k] + u[k + 1] + u[k + 2];
    EXPECT_EQ(side * plane_side(u[k], u[k + 1], u[k + 2], middle), 1);
    EXPECT_EQ(side * plane_side(u[k], u[k + 1], u[k + 2], 0.3 * middle), -1);
  }
}

// Two edges through points p and s p of one ray; a unit of the last place decides where they nearly meet.
TEST(TheoremSigns, TellsWhichEdgeIsFarther) {
  const Vec3 ray(0.3, -0.2, 0.9);
  const Vec3 along(1.0, 0.5, 0.1);
  const Vec3 across(-0.2, 1.0, 0.4);
  for (const double s : {0.5, 0.999, 1.001, 2.0}) {
    const Crossing found = crossing(s * (ray - along), s * (ray + along), ray - across, ray + across);
    EXPECT_TRUE(found.crosses);
    EXPECT_EQ(found.order, s > 1.0 ? 1 : -1) << s;
    EXPECT_FALSE(crossing(-s * (ray - along), -s * (ray + along), ray - across, ray + across).crosses);
    EXPECT_FALSE(crossing(s * (ray + 0.1 * along), s * (ray + along), ray - across, ray + across).crosses);
  }
  const Vec3 a(-1.0, 0.0, 4.0);
  const Vec3 b(1.0, 0.0, 4.0);
  const double more = std::nextafter(4.0, 5.0);
  EXPECT_EQ(crossing(a, b, {0, -1, 4}, {0, 1, 4}).order, 0);
  EXPECT_EQ(crossing(a, b, {0, -1, 4}, {0, 1, more}).order, -1);
  EXPECT_EQ(crossing({-1, 0, more}, b, {0, -1, 4}, {0, 1, 4}).order, 1);
}

TEST(Crossing, TakesInTheEnds) {
  EXPECT_TRUE(crossing({0, 0, 3}, {1, 0, 3}, {0, -1, 2}, {0, 1, 2}).crosses);
  EXPECT_EQ(crossing({0, 0, 3}, {1, 0, 3}, {0, -1, 2}, {0, 1, 2}).order, 1);
  EXPECT_TRUE(crossing({0, 0, 3}, {1, 0, 3}, {0, 0, 3}, {0, 1, 2}).crosses);
  EXPECT_EQ(crossing({0, 0, 3}, {1, 0, 3}, {0, 0, 3}, {0, 1, 2}).order, 0);
  EXPECT_FALSE(crossing({0, 0, 3}, {1, 0, 3}, {-1, 0, 3}, {0, 0, 2}).crosses);  // one plane with the centre
}

// p = a + l (b - a) and q = c + m (d - c) on one ray, found by solving p = s q in floating point.
TEST(Crossing, AgreesWithTheSolvedEquationOnRandomEdges) {
  const auto u = test::random_directions(40000, 4);
  int crossed = 0;
  for (std::size_t k = 0; k + 3 < u.size(); k += 4) {
    const Vec3 &a = u[k], b = 2.0 * u[k + 1], &c = u[k + 2], d = 1.5 * u[k + 3];
    Eigen::Matrix3d m;  // a = -l (b - a) + s c + s m (d - c)
    m << a - b, c, d - c;
    const Vec3 x = m.fullPivLu().solve(a);
    const double share = x.z() / x.y();
    const bool expected = x.x() >= 0.0 && x.x() <= 1.0 && x.y() > 0.0 && share >= 0.0 && share <= 1.0;
    const Crossing found = crossing(a, b, c, d);
    ASSERT_EQ(found.crosses, expected);
    if (!expected) continue;
    ++crossed;
    ASSERT_EQ(found.order, x.y() > 1.0 ? 1 : -1);
  }
  EXPECT_GT(crossed, 300);
}

}  // namespace
}  // namespace impinge

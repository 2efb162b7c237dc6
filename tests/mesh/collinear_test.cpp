// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: collinear(a, b, c) <=> (b - a) x (c - a) = 0 in exact arithmetic on the given doubles.
#include "mesh/collinear.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace impinge {
namespace {

TEST(Collinear, IntegersAgainstExactIntegerArithmetic) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> coordinate(-3, 3);
  int collinear_triples = 0;
  for (int round = 0; round < 20000; ++round) {
    std::array<Eigen::Vector3i, 3> p;
    for (auto& point : p) point = {coordinate(random), coordinate(random), coordinate(random)};
    const Eigen::Vector3i s = p[1] - p[0];
    const Eigen::Vector3i t = p[2] - p[0];
    const bool zero =
        s.y() * t.z() == s.z() * t.y() && s.z() * t.x() == s.x() * t.z() && s.x() * t.y() == s.y() * t.x();
    collinear_triples += zero ? 1 : 0;
    EXPECT_EQ(collinear(p[0].cast<double>(), p[1].cast<double>(), p[2].cast<double>()), zero);
  }
  EXPECT_GT(collinear_triples, 100);
}

// One bit off a line is off the line, however long it is and wherever it starts.
TEST(Collinear, OneBitDecides) {
  const Vec3 a(1.0, 2.0, 3.0);
  const Vec3 b = 2.0 * a;
  const Vec3 c = 3.0 * a;
  EXPECT_TRUE(collinear(a, b, c));
  for (int k = 0; k < 3; ++k) {
    for (const double to : {-1e300, 1e300}) {
      Vec3 moved = c;
      moved[k] = std::nextafter(moved[k], to);
      EXPECT_FALSE(collinear(a, b, moved));
      EXPECT_FALSE(collinear(moved, a, b));
    }
  }
}

// 0.1, 0.2 and 0.3 as doubles: 0.2 is twice 0.1, but 0.3 is not three times it. 0.1 + 0.2 is not either, but
// on the diagonal anything is.
TEST(Collinear, DecimalsAreTakenAsTheDoublesTheyAre) {
  EXPECT_FALSE(collinear({0.1, 1.0, 0.0}, {0.2, 2.0, 0.0}, {0.3, 3.0, 0.0}));
  EXPECT_TRUE(collinear({0.1, 1.0, 0.0}, {0.2, 2.0, 0.0}, {0.4, 4.0, 0.0}));
  EXPECT_TRUE(collinear({0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.3, 0.3, 0.3}));
}

TEST(Collinear, AtAnyScale) {
  const Vec3 a(1.0, 2.0, 3.0);
  const Vec3 b(-2.0, 5.0, 7.0);
  const Vec3 on = 0.5 * (a + b);
  const Vec3 off = on + Vec3(0.0, 0.0, 0x1p-40);
  for (const int e : {-1000, -500, -100, 0, 100, 500, 1000}) {
    const auto at = [e](const Vec3& p) {
      return Vec3(std::ldexp(p.x(), e), std::ldexp(p.y(), e), std::ldexp(p.z(), e));
    };
    EXPECT_TRUE(collinear(at(a), at(b), at(on))) << e;
    EXPECT_FALSE(collinear(at(a), at(b), at(off))) << e;
  }
}

TEST(Collinear, SliversFarFromTheOriginAndHugeSpans) {
  EXPECT_FALSE(collinear({1e8, 1e8, 0.0}, {1e8 + 1.0, 1e8, 0.0}, {1e8 + 0.5, 1e8 + 0x1p-26, 0.0}));
  EXPECT_FALSE(collinear({0.0, 0.0, 0.0}, {1e70, 0.0, 0.0}, {0.0, 1e-70, 0.0}));
  EXPECT_TRUE(collinear({0.0, 0.0, 0.0}, {1e70, 0.0, 0.0}, {1e-70, 0.0, 0.0}));
}

TEST(Collinear, EqualPoints) {
  const Vec3 a(0.1, 0.7, -0.3);
  const Vec3 b(5.0, 1e-9, 1e9);
  EXPECT_TRUE(collinear(a, a, b));
  EXPECT_TRUE(collinear(a, b, a));
  EXPECT_TRUE(collinear(Vec3::Zero(), Vec3::Zero(), Vec3::Zero()));
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_FALSE(collinear(Vec3::Zero(), {tiny, 0.0, 0.0}, {0.0, tiny, 0.0}));
}

}  // namespace
}  // namespace impinge

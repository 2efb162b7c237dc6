// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: the zones hold the area of the vertices whose gap is at most the threshold, where they stand on
// the dial.
#include "hip/close_zones.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace impinge {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// A point at `hours` of a dial that is looked at along x: 12 up, 3 anterior.
Vec3 at(double hours) {
  const double angle = hours * kPi / 6.0;
  return {-1.0, std::sin(angle), std::cos(angle)};
}

TEST(CloseZones, HoldTheVerticesWithinTheThreshold) {
  const std::vector<Vec3> vertices{at(1.1), at(1.4), at(7.1), at(3.1), at(9.1)};
  const std::vector<double> gap{1.9, 2.0, -0.5, 2.1, kNan};
  const std::vector<double> area{2.0, 3.0, 4.0, 8.0, 16.0};
  const auto zones = close_zones(ClockFace{}, {vertices, gap, area}, 2.0);
  ASSERT_EQ(zones.size(), 2U);
  EXPECT_EQ(zones[0].from, 1.0);
  EXPECT_EQ(zones[0].to, 1.5);
  EXPECT_EQ(zones[0].area, 5.0);
  EXPECT_EQ(zones[1].from, 7.0);
  EXPECT_EQ(zones[1].to, 7.25);
  EXPECT_EQ(zones[1].area, 4.0);
}

TEST(CloseZones, ThereAreNoneWhereNothingIsClose) {
  const std::vector<Vec3> vertices{at(1.0), at(2.0)};
  const std::vector<double> gap{5.0, kNan};
  const std::vector<double> area{1.0, 1.0};
  EXPECT_TRUE(close_zones(ClockFace{}, {vertices, gap, area}, 2.0).empty());
}

}  // namespace
}  // namespace impinge

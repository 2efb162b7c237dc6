// SPDX-License-Identifier: GPL-3.0-or-later
// Equal-area octahedral map: ring s of 4 s entries at z = 1 - (s / n)^2, the south mirrored.
//   N rho^2 = 6.74 at 52,000 entries, -> 2 + pi^2 / 2 = 6.935
#include "sphere/schemes/octahedral_equal_area.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sphere/largest_gap.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

TEST(OctahedralEqualArea, AxesAreEntries) {
  for (const double precision : {90.0, 30.0, 1.0}) {
    const auto scheme = OctahedralEqualArea::with_precision(precision);
    const std::size_t n = scheme.divisions();
    const Ring equator = scheme.ring(n);
    EXPECT_EQ(equator.count, scheme.equator_points());
    EXPECT_EQ(scheme.direction(0), Vec3(0, 0, 1));
    EXPECT_EQ(scheme.direction(scheme.size() - 1), Vec3(0, 0, -1));
    EXPECT_EQ(scheme.direction(equator.first), Vec3(1, 0, 0));
    EXPECT_EQ(scheme.direction(equator.first + n), Vec3(0, 1, 0));
    EXPECT_EQ(scheme.direction(equator.first + 2 * n), Vec3(-1, 0, 0));
    EXPECT_EQ(scheme.direction(equator.first + 3 * n), Vec3(0, -1, 0));
  }
}

// Every cell has the area 4 pi / (4 n^2): uniform directions meet each as often.
TEST(OctahedralEqualArea, CellsHaveEqualAreas) {
  const auto scheme = OctahedralEqualArea::with_precision(30.0);
  std::vector<int> hits(scheme.cells(), 0);
  const int each = 10000;
  for (const Vec3& u : test::random_directions(scheme.cells() * each, 60)) ++hits[scheme.stencil(u).cell];
  for (const int count : hits) EXPECT_NEAR(count, each, 5.0 * std::sqrt(each));
}

TEST(OctahedralEqualArea, CoveringRadiusIsTheLargestGap) {
  for (const double n : {1.0, 2.0, 3.0, 4.0, 9.0, 16.0}) {
    const auto scheme = OctahedralEqualArea::with_precision(90.0 / n);
    std::vector<Vec3> entries;
    for (std::size_t i = 0; i < scheme.size(); ++i) entries.push_back(scheme.direction(i));
    EXPECT_NEAR(largest_gap(entries, -1.0, 1.6 / n), scheme.covering_radius(), 1e-12);
  }
}

TEST(OctahedralEqualArea, CoveringConstantIsTheKnownOne) {
  const auto constant = [](double n) {
    const auto scheme = OctahedralEqualArea::with_precision(90.0 / n);
    return static_cast<double>(scheme.size()) * scheme.covering_radius() * scheme.covering_radius();
  };
  EXPECT_NEAR(constant(114.0), 6.743, 0.02 * 6.743);
  const double limit = 2.0 + 0.5 * kPi * kPi;
  EXPECT_LT(constant(4096.0), limit);
  EXPECT_NEAR(constant(4096.0), limit, 0.01 * limit);
  EXPECT_NEAR(constant(9e7), limit, 1e-6);
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Cube maps: entry (i, j) of a face along (+-1, a_i, a_j), a_k = -1 + 2 k / n or tan of pi / 4 of it.
#include <array>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "sphere/schemes/cube_equiangular.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"

namespace impinge {
namespace {

template <class S>
class Cube : public testing::Test {};

using Cubes = testing::Types<CubeGnomonic, CubeEquiangular>;
TYPED_TEST_SUITE(Cube, Cubes);

// Number of entries for each direction, compared bit for bit (but for the sign of zero).
template <class S>
std::map<std::array<double, 3>, int> copies(const S& scheme) {
  std::map<std::array<double, 3>, int> count;
  for (std::size_t i = 0; i < scheme.size(); ++i) {
    const Vec3 u = scheme.direction(i);
    ++count[{u.x(), u.y(), u.z()}];
  }
  return count;
}

TYPED_TEST(Cube, EntriesOnSharedEdgesAreEqualBitForBit) {
  for (const double precision : {90.0, 45.0, 30.0, 12.5, 1.0}) {
    const auto scheme = TypeParam::with_precision(precision);
    const std::size_t n = scheme.divisions();
    const auto count = copies(scheme);
    EXPECT_EQ(count.size(), 6 * n * n + 2);
    std::size_t corners = 0;
    for (const auto& [u, times] : count) corners += times == 3 ? 1U : 0U;
    EXPECT_EQ(corners, 8U);
  }
}

TYPED_TEST(Cube, AxesAndDiagonalsAreExact) {
  const auto count = copies(TypeParam::with_precision(1.0));
  const double half = 1.0 / std::sqrt(2.0);
  for (const double side : {1.0, -1.0}) {
    EXPECT_TRUE(count.contains({side, 0.0, 0.0}));
    EXPECT_TRUE(count.contains({0.0, side, 0.0}));
    EXPECT_TRUE(count.contains({0.0, 0.0, side}));
    EXPECT_TRUE(count.contains({side * half, half, 0.0}));
    EXPECT_TRUE(count.contains({0.0, side * half, -half}));
  }
}

TYPED_TEST(Cube, EquatorPointsStandOnTheEquator) {
  const auto scheme = TypeParam::with_precision(1.0);
  EXPECT_EQ(scheme.equator_points(), 360U);
  EXPECT_EQ(scheme.precision_deg(), 1.0);
  std::size_t on_equator = 0;
  for (const auto& [u, times] : copies(scheme)) on_equator += u[2] == 0.0 ? 1U : 0U;
  EXPECT_EQ(on_equator, 360U);
}

}  // namespace
}  // namespace impinge

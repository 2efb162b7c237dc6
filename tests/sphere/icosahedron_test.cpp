// SPDX-License-Identifier: GPL-3.0-or-later
// Icosahedral grids: nodes w(i) a + w(j) b + w(k) c of each face, i + j + k = n.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "sphere/schemes/icosahedral_gnomonic.hpp"
#include "sphere/schemes/icosahedral_sine.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

template <class S>
class IcosahedralGrids : public testing::Test {};

using Grids = testing::Types<IcosahedralGnomonic, IcosahedralSine>;
TYPED_TEST_SUITE(IcosahedralGrids, Grids);

TYPED_TEST(IcosahedralGrids, NoDirectionIsStoredTwice) {
  for (const double precision : {90.0, 36.0, 24.0, 10.0, 2.0}) {
    const auto scheme = TypeParam::with_precision(precision);
    std::set<std::array<long, 3>> directions;
    for (std::size_t i = 0; i < scheme.size(); ++i) {
      const Vec3 u = scheme.direction(i);
      directions.insert({std::lround(1e9 * u.x()), std::lround(1e9 * u.y()), std::lround(1e9 * u.z())});
    }
    EXPECT_EQ(directions.size(), scheme.size());
  }
}

TYPED_TEST(IcosahedralGrids, CornersOfTheIcosahedronAreEntries) {
  const auto scheme = TypeParam::with_precision(5.0);
  const double z = 1.0 / std::sqrt(5.0);
  for (const Vec3& corner : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(2 * z, 0, z), Vec3(-2 * z, 0, -z)}) {
    double nearest = kPi;
    for (std::size_t i = 0; i < scheme.size(); ++i)
      nearest = std::min(nearest, angle_between(corner, scheme.direction(i)));
    EXPECT_LT(nearest, 4e-16);
  }
  EXPECT_EQ(scheme.direction(scheme.size() - 2), Vec3(0, 0, 1));
  EXPECT_EQ(scheme.direction(scheme.size() - 1), Vec3(0, 0, -1));
}

TEST(IcosahedralGnomonic, EquatorPointsStandOnTheEquator) {
  const auto scheme = IcosahedralGnomonic::with_precision(1.0);
  EXPECT_EQ(scheme.equator_points(), 360U);
  EXPECT_EQ(scheme.precision_deg(), 1.0);
  std::size_t on_equator = 0;
  for (std::size_t i = 0; i < scheme.size(); ++i) {
    on_equator += std::abs(scheme.direction(i).z()) < 1e-12 ? 1U : 0U;
  }
  EXPECT_EQ(on_equator, 360U);
}

// Sine-warped rows bulge: the 5 n entries that stand for the equator are within 0.8 degrees of it.
TEST(IcosahedralSine, EquatorPointsStandNearTheEquator) {
  const auto scheme = IcosahedralSine::with_precision(4.0);
  EXPECT_EQ(scheme.equator_points(), 90U);
  std::size_t near_equator = 0;
  for (std::size_t i = 0; i < scheme.size(); ++i) {
    near_equator += std::abs(scheme.direction(i).z()) < std::sin(0.8 * kDegree) ? 1U : 0U;
  }
  EXPECT_EQ(near_equator, 90U);
}

// A precision that does not divide 72 degrees is rounded to the next finer grid.
TYPED_TEST(IcosahedralGrids, PrecisionIsAtMostTheOneAskedFor) {
  EXPECT_EQ(TypeParam::with_precision(10.0).precision_deg(), 9.0);
  EXPECT_EQ(TypeParam::with_precision(0.05).divisions(), 1440U);
}

TEST(IcosahedralGnomonic, CoveringRadiusHasAClosedForm) {
  for (const double n : {1.0, 2.0, 4.0, 5.0, 71.0, 73.0}) {
    EXPECT_NEAR(IcosahedralGnomonic::with_precision(72.0 / n).covering_radius(),
                std::atan((3.0 - std::sqrt(5.0)) / n), 1e-12 / n);
  }
}

// The ranges of the fractions over a box of flat coordinates hold those of its points: the walker relies on
// it.
TEST(IcosahedralSine, WidenedRangesHoldTheirPoints) {
  const auto directions = test::random_directions(3000, 53);
  for (std::size_t k = 0; k + 2 < directions.size(); k += 3) {
    std::array<Vec3, 3> corner;
    const double size = std::pow(10.0, -static_cast<double>(k % 4));
    const Vec3 start = directions[k].cwiseAbs() / directions[k].cwiseAbs().sum();
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3 other = directions[(k + c + 1) % directions.size()].cwiseAbs();
      corner[c] = start + size * (other / other.sum() - start);
    }
    TriangleRange range{corner[0].cwiseMin(corner[1]).cwiseMin(corner[2]),
                        corner[0].cwiseMax(corner[1]).cwiseMax(corner[2])};
    SineIcosahedralWarp::widen(range);
    for (double s = 0.0; s <= 1.0; s += 0.125) {
      for (double t = 0.0; s + t <= 1.0; t += 0.125) {
        const Vec3 u =
            SineIcosahedralWarp::fractions(corner[0] * (1.0 - s - t) + corner[1] * s + corner[2] * t);
        ASSERT_TRUE((u.array() >= range.low.array() - 1e-14).all() &&
                    (u.array() <= range.high.array() + 1e-14).all());
      }
    }
  }
}

}  // namespace
}  // namespace impinge

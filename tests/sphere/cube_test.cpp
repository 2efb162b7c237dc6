// SPDX-License-Identifier: GPL-3.0-or-later
// Cube maps: entry (i, j) of a face along (+-1, a_i, a_j), a_k = -1 + 2 k / n or tan of pi / 4 of it.
//   N rho^2 -> 12 and 3 pi^2 / 4, N the entries that differ
//   1 / depth of a plane is reproduced exactly by the gnomonic one
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "sphere/schemes/cube_equiangular.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "support/directions.hpp"

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

// Repeated entries raise N by the factor (n + 1)^2 / (n^2 + 1/3): 2.2 % at n = 93.
TYPED_TEST(Cube, CoveringConstantIsTheClosedForm) {
  const double expected = TypeParam::name == "cube_gnomonic" ? 12.0 : 0.75 * kPi * kPi;
  for (const double n : {92.0, 93.0}) {
    const auto scheme = TypeParam::with_precision(90.0 / n);
    const double rho = scheme.covering_radius();
    EXPECT_NEAR((6.0 * n * n + 2.0) * rho * rho, expected, 0.02 * expected);
    EXPECT_NEAR(static_cast<double>(scheme.size()) * rho * rho, expected, 0.023 * expected);
  }
}

// The widest cell is in the middle of the face: no direction is farther from the nearest corner of its cell.
TYPED_TEST(Cube, NoCellIsWiderThanTheMiddleOne) {
  for (const double precision : {90.0, 45.0, 30.0, 22.5, 10.0, 9.0, 1.0}) {
    const auto scheme = TypeParam::with_precision(precision);
    double farthest = 0.0;
    auto probes = test::random_directions(200000, 50);
    probes.push_back(Vec3::UnitX());
    for (const Vec3& u : probes) {
      const Stencil stencil = scheme.stencil(u);
      double nearest = kPi;
      for (const std::size_t i : stencil.entry)
        nearest = std::min(nearest, angle_between(u, scheme.direction(i)));
      farthest = std::max(farthest, nearest);
    }
    EXPECT_LE(farthest, scheme.covering_radius() * (1.0 + 1e-12)) << precision;
    EXPECT_GE(farthest, 0.97 * scheme.covering_radius()) << precision;
  }
}

TYPED_TEST(Cube, FineGridsAreCheapToMake) {
  const auto scheme = TypeParam::with_precision(1e-6);
  EXPECT_EQ(scheme.size(), std::size_t{6} * 90000001 * 90000001);
  EXPECT_NEAR(scheme.covering_radius(),
              std::sqrt((TypeParam::name == "cube_gnomonic" ? 12.0 : 0.75 * kPi * kPi) / 6.0) / 9e7,
              1e-5 / 9e7);
  const Vec3 u = Vec3(0.3, -0.8, 0.1).normalized();
  for (const std::size_t i : scheme.stencil(u).entry)
    EXPECT_LE(angle_between(u, scheme.direction(i)), scheme.stencil_radius());
}

// n.x = p along u = (1, a, b) / s has depth p s / (n.(1, a, b)) / s, so that 1 / depth is linear in (a, b).
TEST(CubeGnomonic, APlanarFaceIsReproducedExactly) {
  const Vec3 normal = Vec3(0.6, 0.5, 0.9).normalized();
  const double distance = 20.0;
  const auto scheme = CubeGnomonic::with_precision(5.0);
  const auto depth_share = [](const Vec3& u) { return u.cwiseAbs().maxCoeff(); };
  for (const Vec3& u : test::random_directions(20000, 51)) {
    if (normal.dot(u) < 0.2) continue;
    const Stencil stencil = scheme.stencil(u);
    double inverse_depth = 0.0;
    for (std::size_t k = 0; k < stencil.taps; ++k) {
      const Vec3 tap = scheme.direction(stencil.entry[k]);
      inverse_depth += stencil.weight[k] * normal.dot(tap) / (distance * depth_share(tap));
    }
    const double exact = distance / normal.dot(u);
    EXPECT_NEAR(1.0 / (inverse_depth * depth_share(u)), exact, 1e-13 * exact);
  }
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "sphere/largest_gap.hpp"
#include "sphere/schemes/cube_equiangular.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "sphere/schemes/fibonacci.hpp"
#include "sphere/schemes/icosahedral_gnomonic.hpp"
#include "sphere/schemes/icosahedral_sine.hpp"
#include "sphere/schemes/octahedral_equal_area.hpp"
#include "support/covering.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

// Icosahedral grids: nodes w(i) a + w(j) b + w(k) c of each face, i + j + k = n.

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

// Cube maps: entry (i, j) of a face along (+-1, a_i, a_j), a_k = -1 + 2 k / n or tan of pi / 4 of it.

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

// Equal-area octahedral map: ring s of 4 s entries at z = 1 - (s / n)^2, the south mirrored.
//   N rho^2 = 6.74 at 52,000 entries, -> 2 + pi^2 / 2 = 6.935

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

// Fibonacci lattice: theta = 2 pi i / golden ratio, z = 1 - 2 (i + 1/4) / (N - 1/2).

TEST(Fibonacci, EntriesStandOnTheLattice) {
  const Fibonacci lattice = Fibonacci::with_precision(1.0);
  EXPECT_EQ(lattice.size(), 41253U);
  EXPECT_EQ(lattice.equator_points(), 360U);
  EXPECT_NEAR(test::covering_constant(lattice, lattice.covering_radius()), 6.73, 0.02);
  const long double golden = (1.0L + std::sqrt(5.0L)) / 2.0L;
  for (std::size_t i = 0; i < lattice.size(); i += 17) {
    const long double turns = static_cast<long double>(i) / golden;
    const long double theta = 2.0L * static_cast<long double>(kPi) * (turns - std::floor(turns));
    const long double z = 1.0L - 2.0L * (static_cast<long double>(i) + 0.25L) / 41252.5L;
    const long double s = std::sqrt(1.0L - z * z);
    const Vec3 expected(static_cast<double>(s * std::cos(theta)), static_cast<double>(s * std::sin(theta)),
                        static_cast<double>(z));
    ASSERT_LT((lattice.direction(i) - expected).norm(), 1e-13) << i;
  }
}

// The triangle that holds u is a Delaunay one: no entry is inside of its circle. All sizes, poles included.
TEST(Fibonacci, TheStencilIsTheDelaunayTriangle) {
  for (const double precision : {60.0, 30.0, 15.0, 7.0, 4.0}) {
    const Fibonacci lattice = Fibonacci::with_precision(precision);
    std::vector<Vec3> entries;
    for (std::size_t i = 0; i < lattice.size(); ++i) entries.push_back(lattice.direction(i));
    for (const Vec3& u : test::random_directions(5000, 81)) {
      const Stencil stencil = lattice.stencil(u);
      ASSERT_EQ(stencil.taps, 3U);
      const std::array<Vec3, 3> corner{entries[stencil.entry[0]], entries[stencil.entry[1]],
                                       entries[stencil.entry[2]]};
      const Vec3 centre = circumcentre(corner[0], corner[1], corner[2]);
      for (const Vec3& e : entries) ASSERT_LT(centre.dot(e), centre.dot(corner[0]) + 1e-12);
      Vec3 inside = Vec3::Zero();
      for (std::size_t k = 0; k < 3; ++k) inside += stencil.weight[k] * corner[k];
      ASSERT_LT(angle_between(inside, u), 1e-12);
    }
  }
}

// The faces of a triangulation.
TEST(Fibonacci, ATriangleHasOneCell) {
  for (const double precision : {60.0, 30.0, 12.0}) {
    const Fibonacci lattice = Fibonacci::with_precision(precision);
    std::set<std::size_t> cells;
    for (const Vec3& u : test::random_directions(100000, 82)) cells.insert(lattice.stencil(u).cell);
    EXPECT_EQ(cells.size(), 2 * lattice.size() - 4);
  }
}

TEST(Fibonacci, RefusesWhatItCannotCount) {
  EXPECT_THROW(Fibonacci::with_precision(61.0), std::invalid_argument);
  EXPECT_THROW(Fibonacci::with_precision(1e-4), std::invalid_argument);
}

}  // namespace
}  // namespace impinge

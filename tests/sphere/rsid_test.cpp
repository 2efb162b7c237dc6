// SPDX-License-Identifier: GPL-3.0-or-later
// LUT[phi][theta]: (180 / p + 1) x (360 / p) entries (thesis, Section 3.4, Table 2).
#include "sphere/schemes/rsid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "sphere/radial_table.hpp"
#include "sphere/schemes/healpix.hpp"
#include "sphere/schemes/latitude_rows.hpp"
#include "sphere/schemes/octahedral_equal_area.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

TEST(Rsid, SizesAreThoseOfTable2) {
  EXPECT_EQ(Rsid::with_precision(1.0).size(), 65160U);
  EXPECT_EQ(Rsid::with_precision(0.5).size(), 259920U);
  EXPECT_EQ(Rsid::with_precision(0.1).size(), 6483600U);
  EXPECT_EQ(Rsid::with_precision(0.05).size(), 25927200U);
  EXPECT_EQ(RadialTable<Rsid>::bytes(Rsid::with_precision(0.05)), 25927200U * 8U);
}

TEST(Rsid, EntriesStandOnTheGrid) {
  const Rsid grid = Rsid::with_precision(30.0);
  for (std::size_t i = 0; i < grid.rows(); ++i) {
    for (std::size_t j = 0; j < grid.columns(); ++j) {
      const Vec3 expected =
          to_direction({static_cast<double>(i) * 30.0 * kDegree, static_cast<double>(j) * 30.0 * kDegree});
      EXPECT_LT((grid.direction(i * grid.columns() + j) - expected).norm(), 1e-15);
    }
  }
}

TEST(Rsid, PolesAndAxesAreExact) {
  const Rsid grid = Rsid::with_precision(1.0);
  EXPECT_EQ(grid.direction(0), Vec3(0, 0, 1));
  EXPECT_EQ(grid.direction(grid.size() - 1), Vec3(0, 0, -1));
  EXPECT_EQ(grid.direction(90 * 360), Vec3(1, 0, 0));
  EXPECT_EQ(grid.direction(90 * 360 + 90), Vec3(0, 1, 0));
  EXPECT_EQ(grid.direction(90 * 360 + 180), Vec3(-1, 0, 0));
}

// r = a + b phi is linear on the grid and reproduced everywhere.
TEST(Rsid, InterpolatesLinearlyInPhi) {
  const Rsid grid = Rsid::with_precision(5.0);
  RadialTable<Rsid> table(grid);
  for (std::size_t i = 0; i < grid.size(); ++i) table.radii()[i] = 10.0 + to_angles(grid.direction(i)).phi;
  for (double phi = 0.01; phi < kPi; phi += 0.037) {
    for (double theta = 0.0; theta < 2.0 * kPi; theta += 0.11) {
      EXPECT_NEAR(table.radius_at(3.0 * to_direction({phi, theta})), 10.0 + phi, 1e-13);
    }
  }
}

// Linear in theta between two columns, the last of which wraps to the first.
TEST(Rsid, InterpolatesLinearlyAcrossTheSeam) {
  const Rsid grid = Rsid::with_precision(10.0);
  RadialTable<Rsid> table(grid);
  for (std::size_t i = 0; i < grid.size(); ++i) table.radii()[i] = i % grid.columns() == 0 ? 20.0 : 10.0;
  EXPECT_NEAR(table.radius_at(to_direction({1.0, 355.0 * kDegree})), 15.0, 1e-12);
  EXPECT_NEAR(table.radius_at(to_direction({1.0, 358.0 * kDegree})), 18.0, 1e-12);
  EXPECT_NEAR(table.radius_at(to_direction({1.0, 2.0 * kDegree})), 18.0, 1e-12);
  EXPECT_DOUBLE_EQ(table.radius_at({1.0, 0.0, 0.0}), table.radius_at({1.0, -0.0, 0.0}));
}

TEST(Rsid, RefusesPrecisionsThatDoNotDivide180) {
  for (const double precision : {0.7, 7.0, 100.0, 180.0}) {
    EXPECT_THROW(Rsid::with_precision(precision), std::invalid_argument) << precision;
  }
  EXPECT_EQ(Rsid::with_precision(90.0).size(), 3U * 4U);
  EXPECT_DOUBLE_EQ(Rsid::with_precision(0.05).precision_deg(), 0.05);
}

TEST(Rsid, HugeTablesAreDescribedWithoutBeingMade) {
  const Rsid grid = Rsid::with_precision(1e-6);
  EXPECT_EQ(grid.size(), (180000000ULL + 1) * 360000000ULL);  // beyond 2^31 and 2^32
  EXPECT_EQ(RadialTable<Rsid>::bytes(grid), grid.size() * 8);
}

TEST(RadialTable, EmptyEntriesAreNoSurface) {
  const Rsid grid = Rsid::with_precision(10.0);
  RadialTable<Rsid> table(grid);
  EXPECT_TRUE(std::isnan(table.radius_at({1.0, 2.0, 3.0})));
  for (double& r : table.radii()) r = 5.0;
  EXPECT_DOUBLE_EQ(table.radius_at({1.0, 2.0, 3.0}), 5.0);
  const Stencil stencil = grid.stencil({1.0, 2.0, 3.0});
  table.radii()[stencil.entry[2]] = kNoSurface;
  EXPECT_TRUE(std::isnan(table.radius_at({1.0, 2.0, 3.0})));
  EXPECT_DOUBLE_EQ(table.radius_at(grid.direction(stencil.entry[0])), 5.0)
      << "on an entry the entry alone decides";
}

TEST(RadialTable, RimCellsAreNoSurface) {
  const Rsid grid = Rsid::with_precision(10.0);
  RadialTable<Rsid> table(grid);
  for (double& r : table.radii()) r = 5.0;
  const Vec3 x(1.0, 2.0, 3.0);
  table.mark_rim_cell(grid.stencil(x).cell);
  EXPECT_TRUE(std::isnan(table.radius_at(x)));
  EXPECT_DOUBLE_EQ(table.radius_at(-x), 5.0);
}

// Latitude rows: m rows of height h = pi / m with round(2 pi sin(phi) / h) entries each, at least 3.

TEST(LatitudeRows, RowsAreFilledAsTheirLengthAsks) {
  const LatitudeRows grid = LatitudeRows::with_precision(1.0);
  EXPECT_EQ(grid.rows(), 180U);
  EXPECT_EQ(grid.row_size(0), 3U);
  EXPECT_EQ(grid.row_size(1), 9U);
  EXPECT_EQ(grid.equator_points(), 360U);
  EXPECT_NEAR(static_cast<double>(grid.size()), 4.0 * kPi / (kDegree * kDegree), 50.0);
  for (std::size_t row = 0; row < grid.rows(); ++row) {
    EXPECT_EQ(grid.row_size(row), grid.row_size(grid.rows() - 1 - row));
    const Vec3 u = grid.direction(grid.first(row));
    EXPECT_NEAR(to_angles(u).phi, (static_cast<double>(row) + 0.5) * kDegree, 1e-14);
  }
}

// r = a + b phi is reproduced between the rows; inside of the polar rows the pole has the mean of its row.
TEST(LatitudeRows, InterpolatesLinearlyInPhi) {
  const LatitudeRows grid = LatitudeRows::with_precision(5.0);
  RadialTable<LatitudeRows> table(grid);
  for (std::size_t i = 0; i < grid.size(); ++i) table.radii()[i] = 10.0 + to_angles(grid.direction(i)).phi;
  for (double phi = 0.01; phi < kPi; phi += 0.037) {
    const double expected = 10.0 + std::clamp(phi, 2.5 * kDegree, kPi - 2.5 * kDegree);
    for (double theta = 0.0; theta < 2.0 * kPi; theta += 0.11) {
      EXPECT_NEAR(table.radius_at(3.0 * to_direction({phi, theta})), expected, 1e-13);
    }
  }
}

TEST(LatitudeRows, CapsHaveThreeTaps) {
  const LatitudeRows grid = LatitudeRows::with_precision(10.0);
  const Stencil pole = grid.stencil({0, 0, 1});
  EXPECT_EQ(pole.taps, 3U);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_DOUBLE_EQ(pole.weight[k], 1.0 / 3.0);
  EXPECT_EQ(grid.stencil(to_direction({4.9 * kDegree, 1.0})).taps, 3U);
  EXPECT_EQ(grid.stencil(to_direction({5.1 * kDegree, 1.0})).taps, 4U);
  EXPECT_EQ(grid.stencil(to_direction({175.1 * kDegree, 1.0})).taps, 3U);
}

// Schemes on rings of latitude: rings hold the entries in their order, and cells across are those that share
// a gap.

template <class S>
class Rings : public testing::Test {};
using OnRings = testing::Types<Healpix, LatitudeRows, OctahedralEqualArea>;
TYPED_TEST_SUITE(Rings, OnRings);

TYPED_TEST(Rings, FollowOneAnother) {
  for (const double precision : {90.0, 45.0, 30.0, 5.0}) {
    const auto scheme = TypeParam::with_precision(precision);
    std::size_t next = 0;
    for (std::size_t k = 0; k < scheme.rings(); ++k) {
      const Ring ring = scheme.ring(k);
      EXPECT_EQ(ring.first, next);
      EXPECT_NEAR(scheme.ring_position(std::atan2(ring.polar.sin, ring.polar.cos)), static_cast<double>(k),
                  1e-12);
      for (std::size_t t = 0; t < ring.count; ++t) EXPECT_EQ(scheme.direction(next + t), ring.direction(t));
      next += ring.count;
    }
    EXPECT_EQ(next, scheme.size());
  }
}

template <class S>
class RingCells : public testing::Test {};
using Interpolated = testing::Types<Healpix, LatitudeRows>;
TYPED_TEST_SUITE(RingCells, Interpolated);

// for_each_cell_across(): the cells that share a gap with this one, found by trying directions.
TYPED_TEST(RingCells, AcrossShareAGap) {
  for (const double precision : {90.0, 45.0, 18.0}) {
    const auto scheme = TypeParam::with_precision(precision);
    const auto upper = [](const Stencil& s) { return std::array{s.entry[0], s.entry[1]}; };
    const auto lower = [](const Stencil& s) { return std::array{s.entry[2], s.entry[3]}; };
    const auto is_cap = [&](const Stencil& s) {
      return s.taps == 0 || s.cell == 0 || s.cell == scheme.cells() - 1;
    };
    std::vector<Stencil> cell(scheme.cells());
    for (const Vec3& u : test::random_directions(100000, 70)) {
      const Stencil stencil = scheme.stencil(u);
      cell[stencil.cell] = stencil;
    }
    for (const Stencil& here : cell) {
      if (is_cap(here)) continue;
      std::set<std::size_t> expected;
      for (const Stencil& other : cell) {
        if (is_cap(other)) continue;
        const bool same_rings = scheme.direction(other.entry[0]).z() == scheme.direction(here.entry[0]).z();
        if (same_rings && (upper(other) == upper(here) || lower(other) == lower(here)))
          expected.insert(other.cell);
      }
      std::set<std::size_t> found;
      scheme.for_each_cell_across(here, [&](const Stencil& other) { found.insert(other.cell); });
      EXPECT_EQ(found, expected) << precision << " cell " << here.cell;
    }
  }
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// LUT[phi][theta]: (180 / p + 1) x (360 / p) entries (thesis, Section 3.4, Table 2).
#include "sphere/schemes/rsid.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sphere/radial_table.hpp"

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

}  // namespace
}  // namespace impinge

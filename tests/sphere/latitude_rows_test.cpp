// SPDX-License-Identifier: GPL-3.0-or-later
// Latitude rows: m rows of height h = pi / m with round(2 pi sin(phi) / h) entries each, at least 3.
#include "sphere/schemes/latitude_rows.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "sphere/radial_table.hpp"
#include "support/covering.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

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

TEST(LatitudeRows, InterpolationIsContinuous) {
  const LatitudeRows grid = LatitudeRows::with_precision(12.0);
  RadialTable<LatitudeRows> table(grid);
  for (std::size_t i = 0; i < grid.size(); ++i) table.radii()[i] = 10.0 + grid.direction(i).sum();
  for (const Vec3& u : test::random_directions(20000, 71)) {
    const Vec3 v = (u + 1e-9 * u.unitOrthogonal()).normalized();
    ASSERT_NEAR(table.radius_at(u), table.radius_at(v), 1e-7) << u.transpose();
  }
}

TEST(LatitudeRows, ACellHasOneStencil) {
  const LatitudeRows grid = LatitudeRows::with_precision(15.0);
  std::vector<Stencil> seen(grid.cells());
  for (const Vec3& u : test::random_directions(100000, 72)) {
    const Stencil stencil = grid.stencil(u);
    Stencil& first = seen[stencil.cell];
    if (first.taps == 0) first = stencil;
    ASSERT_EQ(first.entry, stencil.entry) << "cell " << stencil.cell;
  }
}

// A way from u to a tap, between two rows, meets only cells that for_each_cell_across() names.
TEST(LatitudeRows, CellsAcrossHoldTheWaysToTheTaps) {
  const LatitudeRows grid = LatitudeRows::with_precision(20.0);
  for (const Vec3& u : test::random_directions(20000, 75)) {
    const Stencil stencil = grid.stencil(u);
    if (stencil.taps == 3) continue;
    std::set<std::size_t> across;
    grid.for_each_cell_across(stencil, [&](const Stencil& other) { across.insert(other.cell); });
    ASSERT_TRUE(across.contains(stencil.cell));
    const auto [phi, theta] = to_angles(u);
    for (std::size_t k = 0; k < 4; ++k) {
      const Angles tap = to_angles(grid.direction(stencil.entry[k]));
      for (double t = 0.0; t < 0.999; t += 0.04) {
        const Vec3 v = to_direction(
            {phi + t * (tap.phi - phi), theta + t * std::remainder(tap.theta - theta, 2.0 * kPi)});
        ASSERT_TRUE(across.contains(grid.stencil(v).cell)) << u.transpose() << " tap " << k;
      }
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

TEST(LatitudeRows, CoveringConstant) {
  const LatitudeRows grid = LatitudeRows::with_precision(180.0 / 202.0);  // 51 950 entries
  const double closed_form = 2.0 * kPi;
  const double away_from_poles = test::climbed_gap(grid, 0.98, 20000, 73);
  EXPECT_NEAR(test::covering_constant(grid, away_from_poles), closed_form, 0.02 * closed_form);
}

TEST(LatitudeRows, RadiiHoldForFewRows) {
  for (double rows = 2.0; rows < 16.0; rows += 1.0) {
    const LatitudeRows grid = LatitudeRows::with_precision(180.0 / rows);
    double farthest = 0.0;
    for (const Vec3& u : test::random_directions(5000, 74)) {
      double nearest = kPi;
      for (std::size_t i = 0; i < grid.size(); ++i)
        nearest = std::min(nearest, angle_between(u, grid.direction(i)));
      farthest = std::max(farthest, nearest);
      const Stencil stencil = grid.stencil(u);
      for (std::size_t k = 0; k < stencil.taps; ++k) {
        ASSERT_LE(angle_between(u, grid.direction(stencil.entry[k])), grid.stencil_radius()) << rows;
      }
    }
    EXPECT_LE(farthest, grid.covering_radius()) << rows;
    EXPECT_GE(farthest, 0.9 * grid.covering_radius()) << rows;
  }
}

}  // namespace
}  // namespace impinge

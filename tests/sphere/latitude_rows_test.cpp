// SPDX-License-Identifier: GPL-3.0-or-later
// Latitude rows: m rows of height h = pi / m with round(2 pi sin(phi) / h) entries each, at least 3.
#include "sphere/schemes/latitude_rows.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sphere/radial_table.hpp"

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

TEST(LatitudeRows, CapsHaveThreeTaps) {
  const LatitudeRows grid = LatitudeRows::with_precision(10.0);
  const Stencil pole = grid.stencil({0, 0, 1});
  EXPECT_EQ(pole.taps, 3U);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_DOUBLE_EQ(pole.weight[k], 1.0 / 3.0);
  EXPECT_EQ(grid.stencil(to_direction({4.9 * kDegree, 1.0})).taps, 3U);
  EXPECT_EQ(grid.stencil(to_direction({5.1 * kDegree, 1.0})).taps, 4U);
  EXPECT_EQ(grid.stencil(to_direction({175.1 * kDegree, 1.0})).taps, 3U);
}

}  // namespace
}  // namespace impinge

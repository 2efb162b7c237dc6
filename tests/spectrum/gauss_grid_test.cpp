// SPDX-License-Identifier: GPL-3.0-or-later
#include "spectrum/gauss_grid.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace impinge {
namespace {

// Integral of x^2p over the sphere: 4 pi / (2 p + 1), exact while 2 p < 2 L.
TEST(GaussGrid, IntegratesPowersExactly) {
  const GaussGrid grid(12);
  const GaussGrid fine(300);
  for (const int p : {0, 50, 299}) {
    double sum = 0.0;
    for (std::size_t i = 0; i < fine.rows(); ++i)
      sum += static_cast<double>(fine.columns()) * fine.weight(i) * std::pow(fine.z(i), 2 * p);
    EXPECT_NEAR(sum, 4.0 * kPi / (2.0 * p + 1.0), 1e-13) << p;
  }
  for (const int p : {0, 1, 3, 5, 11}) {
    for (const int axis : {0, 1, 2}) {
      double sum = 0.0;
      for (std::size_t i = 0; i < grid.rows(); ++i) {
        for (std::size_t j = 0; j < grid.columns(); ++j)
          sum += grid.weight(i) * std::pow(grid.direction(i, j)[axis], 2 * p);
      }
      EXPECT_NEAR(sum, 4.0 * kPi / (2.0 * p + 1.0), 1e-13) << p << ' ' << axis;
    }
  }
}

TEST(GaussGrid, RunsDownFromThePole) {
  for (const std::size_t limit : {1U, 2U, 7U, 64U}) {
    const GaussGrid grid(limit);
    EXPECT_EQ(grid.size(), 2 * limit * limit);
    for (std::size_t i = 0; i < grid.rows(); ++i) {
      if (i > 0) {
        EXPECT_LT(grid.z(i), grid.z(i - 1));
      }
      EXPECT_NEAR(grid.z(i), -grid.z(grid.rows() - 1 - i), 1e-15);
      EXPECT_NEAR(grid.direction(i, 1 % grid.columns()).norm(), 1.0, 4e-16);
      EXPECT_NEAR(to_angles(grid.direction(i, 0)).phi, grid.phi(i), 1e-12);
    }
  }
}

TEST(GaussGrid, CoveredShareIsBySolidAngle) {
  const GaussGrid grid(64);
  const auto half = sample(grid, [](const Vec3& u) { return u.z() > 0.0 ? 1.0 : std::nan(""); });
  EXPECT_NEAR(covered_share(grid, half), 0.5, 1e-12);
  EXPECT_EQ(covered_share(grid, sample(grid, [](const Vec3&) { return 1.0; })), 1.0);
}

TEST(GaussGrid, RefusesSizesThatMakeNoSense) {
  EXPECT_THROW(GaussGrid(0), std::invalid_argument);
  EXPECT_THROW(GaussGrid(4097), std::invalid_argument);
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// membrane: zero Laplacian; in a cap of half-angle a with the edge value cos(m theta) it is
//           (tan(phi / 2) / tan(a / 2))^m cos(m theta), because the Laplacian is conformal
// plate:    least squared Laplacian
#include "spectrum/hole_filling.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "spectrum/harmonic_transform.hpp"
#include "spectrum/power_spectrum.hpp"

namespace impinge {
namespace {

constexpr double kHole = 0.6;  // radians

std::vector<double> with_hole(const GaussGrid& grid, std::vector<double> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (grid.phi(i / grid.columns()) < kHole) values[i] = std::nan("");
  }
  return values;
}

// Sum of l^p (l + 1)^p |a_lm|^2, the energy that a filling makes least.
double energy(const GaussGrid& grid, const std::vector<double>& values, double p) {
  const auto power = power_by_degree(analyse(grid, values));
  double sum = 0.0;
  for (std::size_t l = 0; l < power.size(); ++l) {
    const auto degree = static_cast<double>(l);
    sum += std::pow(degree * (degree + 1.0), p) * power[l];
  }
  return sum;
}

TEST(HoleFilling, LeavesAClosedSurfaceAlone) {
  const GaussGrid grid(16);
  const auto values = sample(grid, [](const Vec3& u) { return 20.0 + u.x() + u.y() * u.z(); });
  for (const Filling filling : {Filling::membrane, Filling::plate})
    EXPECT_EQ(fill_holes(grid, values, filling), values);
}

TEST(HoleFilling, KeepsWhatIsThereAndAConstantIsAConstant) {
  const GaussGrid grid(32);
  for (const Filling filling : {Filling::membrane, Filling::plate}) {
    for (const double v : fill_holes(grid, with_hole(grid, std::vector<double>(grid.size(), 7.0)), filling))
      ASSERT_NEAR(v, 7.0, 1e-9);
    const auto values = sample(grid, [](const Vec3& u) { return 20.0 + u.x() * u.z(); });
    const auto open = with_hole(grid, values);
    const auto filled = fill_holes(grid, open, filling);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!std::isnan(open[i])) {
        ASSERT_EQ(filled[i], values[i]);
      }
    }
  }
}

TEST(HoleFilling, MembraneIsHarmonic) {
  const auto largest_error = [](std::size_t limit, int m) {
    const GaussGrid grid(limit);
    const auto exact = sample(grid, [m](const Vec3& u) {
      const auto [phi, theta] = to_angles(u);
      return std::pow(std::tan(0.5 * phi), m) * std::cos(m * theta);
    });
    const auto filled = fill_holes(grid, with_hole(grid, exact), Filling::membrane);
    double largest = 0.0;
    for (std::size_t i = 0; i < filled.size(); ++i) {
      if (grid.phi(i / grid.columns()) < kHole) largest = std::max(largest, std::abs(filled[i] - exact[i]));
    }
    return largest;
  };
  for (const int m : {1, 2, 5}) {
    EXPECT_LT(largest_error(64, m), 2e-4) << m;
    EXPECT_LT(largest_error(128, m), 0.35 * largest_error(64, m)) << m << ": not of second order";
  }
}

// Neither filling can be made better by adding a bump in the hole.
TEST(HoleFilling, HasTheLeastEnergy) {
  const GaussGrid grid(48);
  const auto open =
      with_hole(grid, sample(grid, [](const Vec3& u) { return std::exp(u.z() + 0.5 * u.x()); }));
  for (const auto& [filling, p] : {std::pair{Filling::membrane, 1.0}, {Filling::plate, 2.0}}) {
    const auto filled = fill_holes(grid, open, filling);
    const double least = energy(grid, filled, p);
    for (const double sign : {-1.0, 1.0}) {
      auto other = filled;
      for (std::size_t i = 0; i < other.size(); ++i) {
        const double t = grid.phi(i / grid.columns()) / kHole;
        if (t < 1.0) other[i] += sign * 0.1 * std::pow(1.0 - t * t, 3.0);
      }
      EXPECT_GT(energy(grid, other, p), least) << name_of(filling) << ' ' << sign;
    }
  }
}

// What the plate adds dies off faster: it has no kink.
TEST(HoleFilling, PlateIsSmoother) {
  const GaussGrid grid(96);
  const auto smooth = sample(grid, [](const Vec3& u) { return std::exp(u.z() + 0.5 * u.x()); });
  const auto high = [&](Filling filling) {
    const auto power = power_by_degree(analyse(grid, fill_holes(grid, with_hole(grid, smooth), filling)));
    return rms_beyond(power, 30);
  };
  EXPECT_LT(high(Filling::plate), 0.05 * high(Filling::membrane));
}

TEST(HoleFilling, RefusesASurfaceThatIsAllHole) {
  const GaussGrid grid(4);
  EXPECT_THROW(fill_holes(grid, std::vector<double>(grid.size(), std::nan("")), Filling::membrane),
               std::invalid_argument);
  EXPECT_THROW(fill_holes(grid, std::vector<double>(3, 1.0), Filling::plate), std::invalid_argument);
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// E(a, b, c, r) = sum (L_i - r)^2 is least (Eberly 1999): its gradient vanishes there and no neighbour is
// lower.
#include "hip/sphere_fit.hpp"

#include <cmath>
#include <random>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/directions.hpp"

namespace impinge {
namespace {

std::vector<Vec3> noisy_cap(const Vec3& centre, double radius, double noise, double lowest_z) {
  std::mt19937_64 random(50);
  std::normal_distribution<double> error(0.0, noise);
  std::vector<Vec3> points;
  for (const Vec3& u : test::random_directions(4000, 51)) {
    if (u.z() >= lowest_z) points.push_back(centre + (radius + error(random)) * u);
  }
  return points;
}

double energy(std::span<const Vec3> points, const Vec3& centre, double radius) {
  double sum = 0.0;
  for (const Vec3& x : points) sum += std::pow((x - centre).norm() - radius, 2);
  return sum;
}

TEST(SphereFit, IsExactOnASphere) {
  const Vec3 centre(-86.0, 20.0, -580.0);
  const auto points = noisy_cap(centre, 24.0, 0.0, -1.0);
  const SphereFit fit = fit_sphere(points);
  EXPECT_LT((fit.centre - centre).norm(), 1e-10);
  EXPECT_NEAR(fit.radius, 24.0, 1e-10);
  EXPECT_LT(fit.rms, 1e-10);
  EXPECT_EQ(fit.points, points.size());
}

// The standard error of the centre is about sigma sqrt(3 / n); five of them are allowed. A cap loses some.
TEST(SphereFit, FindsTheCentreThroughNoise) {
  const Vec3 centre(5.0, -3.0, 8.0);
  for (const double lowest : {-1.0, 0.0}) {
    const auto points = noisy_cap(centre, 24.0, 0.5, lowest);
    const SphereFit fit = fit_sphere(points);
    const double loss = lowest < 0.0 ? 1.0 : 4.0;
    EXPECT_LT((fit.centre - centre).norm(),
              loss * 5.0 * 0.5 * std::sqrt(3.0 / static_cast<double>(points.size())));
    EXPECT_NEAR(fit.rms, 0.5, 0.03);
  }
}

TEST(SphereFit, NoNeighbourHasALowerEnergy) {
  const auto points = noisy_cap({1.0, 2.0, 3.0}, 20.0, 1.0, 0.2);
  const SphereFit fit = fit_sphere(points);
  const double least = energy(points, fit.centre, fit.radius);
  for (const Vec3& u : test::random_directions(50, 52)) {
    for (const double step : {1e-4, 1e-2}) {
      EXPECT_GT(energy(points, fit.centre + step * u, fit.radius), least);
      EXPECT_GT(energy(points, fit.centre, fit.radius + step), least);
      EXPECT_GT(energy(points, fit.centre, fit.radius - step), least);
    }
  }
}

TEST(SphereFit, WeightsStandForRepeatedPoints) {
  auto points = noisy_cap({1.0, 2.0, 3.0}, 20.0, 1.0, 0.5);
  std::vector<double> weight(points.size(), 1.0);
  weight[3] = 3.0;
  weight[7] = 0.0;
  const SphereFit weighted = fit_sphere(points, weight);
  points.push_back(points[3]);
  points.push_back(points[3]);
  points.erase(points.begin() + 7);
  const SphereFit repeated = fit_sphere(points);
  EXPECT_LT((weighted.centre - repeated.centre).norm(), 1e-9);
}

TEST(SphereFit, RefusesTooFewPointsAndPlanes) {
  const std::vector<Vec3> three{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_THROW(fit_sphere(three), std::invalid_argument);
  std::vector<Vec3> flat;
  for (int k = 0; k < 50; ++k) flat.emplace_back(std::cos(k), std::sin(k), 0.0);
  EXPECT_THROW(fit_sphere(flat), std::invalid_argument);
}

}  // namespace
}  // namespace impinge

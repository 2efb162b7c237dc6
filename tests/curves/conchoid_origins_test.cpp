// SPDX-License-Identifier: GPL-3.0-or-later
// Centres of a conchoid's cap: of a circle in closed form, the best sphere against a fit of points.
#include "curves/conchoid_origins.hpp"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "curves/conchoid_surface.hpp"
#include "hip/sphere_fit.hpp"

namespace impinge {
namespace {

const ConchoidShape kRound{22.0, 0.0};

// Of a circle every whole-curve centre is the circle's; of the half circle r / 2 and 2 r / pi are known.
TEST(ConchoidOrigins, CentresOfACircle) {
  for (const SamplingOrigin& at : sampling_origins(kRound)) {
    double expected = 0.0;
    if (at.name == "cap_extent_middle" || at.name == "cap_surface_centroid") expected = 11.0;
    if (at.name == "cap_curve_centroid") expected = 44.0 / kPi;
    EXPECT_NEAR(at.height, expected, 1e-9) << at.name;
  }
  EXPECT_GE(sampling_origins(kRound).size(), 4U);
  EXPECT_EQ(sampling_origins({}).size(), 9U);
}

// Against the fit of points that stand for equal areas.
TEST(ConchoidOrigins, BestSphereIsThatOfTheSurface) {
  const auto points = conchoid_spiral({}, 20000);
  const SphereFit expected = fit_sphere(points);
  const AxialSphere sphere = fit_axial_sphere({});
  EXPECT_NEAR(sphere.height, expected.centre.z(), 1e-3);
  EXPECT_NEAR(sphere.radius, expected.radius, 1e-3);
  double lowest = 0.0;
  double highest = 0.0;
  for (const Vec3& p : points) {
    const double residual = (p - expected.centre).norm() - expected.radius;
    lowest = std::min(lowest, residual);
    highest = std::max(highest, residual);
  }
  EXPECT_NEAR(sphere.lowest_residual, lowest, 5e-3);
  EXPECT_NEAR(sphere.highest_residual, highest, 5e-3);
}

TEST(ConchoidOrigins, RefusesWhatIsNoShape) {
  EXPECT_THROW(sampling_origins({1.0, 2.0}), std::invalid_argument);
  EXPECT_THROW(fit_axial_sphere({0.0, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace impinge

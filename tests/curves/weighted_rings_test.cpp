// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. 16 as a scheme: rings where the rays of the thesis stand, and look-ups that find them.
#include "curves/weighted_rings.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "curves/conchoid_rays.hpp"
#include "support/directions.hpp"

namespace impinge::lab {
namespace {

// The rays of the closed form, which is another's code, and their mirror images.
TEST(WeightedRings, StandWhereTheRaysAre) {
  const auto scheme = WeightedRings::with_precision(3.0);
  const auto rays = adjusted_angles(closed_form({}), 31);
  ASSERT_EQ(scheme.size(), 61U * 120U);
  for (std::size_t i = 0; i <= 30; ++i) {
    EXPECT_NEAR(scheme.ring(i), rays[i], 1e-12);
    EXPECT_NEAR(scheme.ring(60 - i), kPi - rays[i], 1e-12);
  }
}

TEST(WeightedRings, EntriesLeadBack) {
  const auto scheme = WeightedRings::with_precision(5.0);
  for (std::size_t entry = 0; entry < scheme.size(); ++entry) {
    const Vec3 u = scheme.direction(entry);
    const Stencil stencil = scheme.stencil(u);
    double there = 0.0;
    for (std::size_t k = 0; k < stencil.taps; ++k) {
      if (angle_between(scheme.direction(stencil.entry[k]), u) < 1e-7) there += stencil.weight[k];
    }
    EXPECT_NEAR(there, 1.0, 1e-6) << entry;
  }
}

// Weights that sum to 1 put the angles between those of the taps, which are near; the nearest is within the
// covering.
TEST(WeightedRings, LookUpsAreLinearInTheAngles) {
  const auto scheme = WeightedRings::with_precision(2.0);
  for (const Vec3& u : test::random_directions(5000, 3)) {
    const Stencil stencil = scheme.stencil(u);
    ASSERT_LT(stencil.cell, scheme.cells());
    double phi = 0.0;
    double sum = 0.0;
    double nearest = kPi;
    for (std::size_t k = 0; k < stencil.taps; ++k) {
      const Vec3 tap = scheme.direction(stencil.entry[k]);
      phi += stencil.weight[k] * to_angles(tap).phi;
      sum += stencil.weight[k];
      nearest = std::min(nearest, angle_between(tap, u));
      EXPECT_GE(stencil.weight[k], 0.0);
      EXPECT_LE(angle_between(tap, u), scheme.stencil_radius());
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_NEAR(phi, to_angles(u).phi, 1e-12);
    EXPECT_LE(nearest, scheme.covering_radius());
  }
  EXPECT_THROW(WeightedRings::with_precision(0.0), std::invalid_argument);
}

}  // namespace
}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// Isotropic helix: theta = sqrt(pi N) phi, entries 2 sqrt(pi / N) apart both ways (Bauer 2000).
#include "sphere/schemes/helix_isotropic.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/covering.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

TEST(HelixIsotropic, PrecisionIsTheSpacingBothWays) {
  const HelixIsotropic helix = HelixIsotropic::with_precision(1.0);
  EXPECT_EQ(helix.size(), 41253U);  // square degrees on the sphere
  EXPECT_EQ(helix.equator_points(), 360U);
  EXPECT_NEAR(helix.precision_deg(), 1.0, 1e-4);
  const std::size_t equator = helix.size() / 2;
  EXPECT_NEAR(angle_between(helix.direction(equator), helix.direction(equator + 1)), kDegree, 1e-3 * kDegree);
}

TEST(HelixIsotropic, BothPolesAreEntries) {
  const HelixIsotropic helix = HelixIsotropic::with_precision(3.0);
  EXPECT_EQ(helix.direction(0), Vec3(0, 0, 1));
  EXPECT_EQ(helix.direction(helix.size() - 1), Vec3(0, 0, -1));
}

TEST(HelixIsotropic, ThreeTapsAtThePolesFourBetween) {
  const HelixIsotropic helix = HelixIsotropic::with_precision(5.0);
  for (double theta = 0.1; theta < 2.0 * kPi; theta += 0.1) {
    EXPECT_EQ(helix.stencil(to_direction({0.002 * theta, theta})).taps, 3U);
    EXPECT_EQ(helix.stencil(to_direction({1.0, theta})).taps, 4U);
    EXPECT_EQ(helix.stencil(to_direction({kPi - 1e-4, theta})).taps, 3U);
  }
}

TEST(HelixIsotropic, CoveringConstant) {
  const HelixIsotropic helix = HelixIsotropic::with_precision(0.9);  // 50 930 entries
  const double closed_form = 2.0 * kPi;
  const double away_from_poles = test::climbed_gap(helix, 0.98, 20000, 61);
  EXPECT_NEAR(test::covering_constant(helix, away_from_poles), closed_form, 0.02 * closed_form);
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Small steps: what is done wrong on purpose is found. (The family as a whole: experiments/11_stability.)
#include <gtest/gtest.h>

#include "stress/azimuth_steps.hpp"

namespace impinge::lab {
namespace {

// Near 360 degrees floats are 3.05e-5 apart.
TEST(AzimuthSteps, FloatsTellColumnsApartAboveTheirSpacing) {
  EXPECT_EQ(float_azimuths(1e-2, 48.0).wrong, 0U);
  EXPECT_EQ(float_azimuths(1e-4, 48.0).wrong, 0U);
  EXPECT_GT(float_azimuths(1e-5, 48.0).wrong, 50U);
}

// Each addition rounds, and all roundings of one sign add up.
TEST(AzimuthSteps, SumsDriftAway) {
  EXPECT_EQ(summed_azimuths(1.0, 48.0).relative_error, 0.0);
  EXPECT_GT(summed_azimuths(1e-3, 48.0).error_over_condition_u, 1e4);
}

}  // namespace
}  // namespace impinge::lab

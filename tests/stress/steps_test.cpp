// SPDX-License-Identifier: GPL-3.0-or-later
// Small steps: the family as a whole, and that what is done wrong on purpose is found.
#include <string>

#include <gtest/gtest.h>

#include "stress/azimuth_steps.hpp"
#include "stress/family.hpp"

namespace impinge::lab {

StabilityFamily tiny_step_family();

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

TEST(TinyStep, EveryEntryIsFoundAndEveryRefusalSaysWhy) {
  const StabilityFamily family = tiny_step_family();
  const std::vector<StabilityCase> cases = family.run({true, 1});
  EXPECT_TRUE(broken(family, cases).empty());
  std::size_t tables = 0;
  for (const StabilityCase& c : cases) {
    if (c.kind != "ours") continue;
    EXPECT_TRUE(c.refused.empty() || c.refused.find('\n') == std::string::npos);
    if (c.refused.find(" bytes") != std::string::npos) ++tables;
  }
  EXPECT_GT(tables, 20U);
}

}  // namespace
}  // namespace impinge::lab

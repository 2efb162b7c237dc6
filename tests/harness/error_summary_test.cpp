// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/error_summary.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace impinge::lab {
namespace {

TEST(ErrorSummary, MaximumCountsAllAndTheRestTheUniformOnes) {
  const std::vector<double> errors{3.0, 4.0, 0.0, 5.0, 100.0};
  const ErrorSummary all = summarise_errors(errors);
  EXPECT_EQ(all.max, 100.0);
  EXPECT_DOUBLE_EQ(all.rms, std::sqrt((9.0 + 16.0 + 25.0 + 1e4) / 5.0));
  const ErrorSummary some = summarise_errors(errors, 4);
  EXPECT_EQ(some.max, 100.0);
  EXPECT_DOUBLE_EQ(some.rms, std::sqrt(50.0 / 4.0));
}

TEST(ErrorSummary, RefusesNothingAndNaN) {
  EXPECT_THROW(summarise_errors({}), std::invalid_argument);
  EXPECT_THROW(summarise_errors(std::vector{1.0}, 2), std::invalid_argument);
  EXPECT_THROW(summarise_errors(std::vector{1.0, std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace impinge::lab

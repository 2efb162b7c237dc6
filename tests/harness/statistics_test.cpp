// SPDX-License-Identifier: GPL-3.0-or-later
// Known answers of type 7 of Hyndman and Fan (1996), as R's quantile() and NumPy's percentile() give by
// default.
#include "harness/statistics.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace impinge::lab {
namespace {

TEST(Statistics, QuantilesInterpolateBetweenOrderStatistics) {
  const std::array<double, 4> samples{40.0, 10.0, 30.0, 20.0};
  EXPECT_DOUBLE_EQ(quantile(samples, 0.0), 10.0);
  EXPECT_DOUBLE_EQ(quantile(samples, 0.25), 17.5);
  EXPECT_DOUBLE_EQ(quantile(samples, 0.5), 25.0);
  EXPECT_DOUBLE_EQ(quantile(samples, 0.75), 32.5);
  EXPECT_DOUBLE_EQ(quantile(samples, 1.0), 40.0);
}

TEST(Statistics, SummaryOfKnownSamples) {
  const std::array<double, 9> samples{9, 8, 7, 6, 5, 4, 3, 2, 1};
  const Summary summary = summarise(samples);
  EXPECT_DOUBLE_EQ(summary.median, 5.0);
  EXPECT_DOUBLE_EQ(summary.iqr, 4.0);
  EXPECT_EQ(summary.count, 9U);
}

TEST(Statistics, OneSampleHasNoSpreadAndNoneIsNotANumber) {
  const std::array<double, 1> one{3.5};
  EXPECT_EQ(summarise(one).median, 3.5);
  EXPECT_EQ(summarise(one).iqr, 0.0);
  EXPECT_TRUE(std::isnan(summarise({}).median));
}

}  // namespace
}  // namespace impinge::lab

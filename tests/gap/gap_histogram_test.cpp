// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: bin k holds the area of gaps in [first + k width, first + (k + 1) width); all parts together hold
// the whole area.
#include "gap/gap_histogram.hpp"

#include <limits>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace impinge {
namespace {

TEST(GapHistogram, PutsAreasIntoTheirBins) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> gap{-5.0, -4.5001, -0.1, 0.0, 0.49, 0.5, 14.99, 15.0, -5.01, none, infinity};
  const std::vector<double> area{1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024};
  const GapHistogram found = gap_histogram(gap, area);
  EXPECT_EQ(found.area[0], 3.0);
  EXPECT_EQ(found.area[9], 4.0);
  EXPECT_EQ(found.area[10], 24.0);
  EXPECT_EQ(found.area[11], 32.0);
  EXPECT_EQ(found.area[39], 64.0);
  EXPECT_EQ(found.beyond, 1152.0);
  EXPECT_EQ(found.below, 256.0);
  EXPECT_EQ(found.without, 512.0);
}

TEST(GapHistogram, HoldsTheWholeArea) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> spread(4.0, 6.0);
  std::vector<double> gap(5000);
  for (double& g : gap) g = spread(random);
  const GapHistogram found = gap_histogram(gap, std::vector<double>(gap.size(), 0.5));
  const double inside = std::accumulate(found.area.begin(), found.area.end(), 0.0);
  EXPECT_EQ(inside + found.below + found.beyond + found.without, 2500.0);
  EXPECT_GT(inside, 2000.0);
  EXPECT_GT(found.below, 0.0);
}

}  // namespace
}  // namespace impinge

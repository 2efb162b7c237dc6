// SPDX-License-Identifier: GPL-3.0-or-later
// Ends of what is proven are shown outward.
#include "files/formatted.hpp"

#include <random>

#include <gtest/gtest.h>

namespace impinge {
namespace {

TEST(Formatted, RoundsEndsOutward) {
  EXPECT_EQ(rounded_down(53.56, 1), "53.5");
  EXPECT_EQ(rounded_up(53.54, 1), "53.6");
  EXPECT_EQ(rounded_down(53.6, 1), "53.6");  // reads back as itself
  EXPECT_EQ(rounded_up(53.6, 1), "53.6");
  EXPECT_EQ(rounded_down(-0.04, 1), "-0.1");
  EXPECT_EQ(rounded_up(-0.04, 1), "0.0");
  EXPECT_EQ(rounded_down(0.05, 1), "0.0");
  EXPECT_EQ(rounded_up(99.999, 2), "100.00");
  EXPECT_EQ(rounded_down(180.0, 1), "180.0");
}

TEST(Formatted, IsWithinAUnitOfTheLastPlace) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> values(-200.0, 200.0);
  for (int k = 0; k < 10'000; ++k) {
    const double value = values(random);
    const int places = k % 5;
    const double low = std::stod(rounded_down(value, places));
    const double high = std::stod(rounded_up(value, places));
    ASSERT_LE(low, value);
    ASSERT_GE(high, value);
    ASSERT_NEAR(low, high, 1.000001 * std::pow(10.0, -places)) << value;
  }
}

}  // namespace
}  // namespace impinge

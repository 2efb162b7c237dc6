// SPDX-License-Identifier: GPL-3.0-or-later
// Oracle: distribution functions written down with erfc(), against which the inverse must come out.
#include "cohort/spread.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "support/thrown.hpp"

namespace impinge::lab {
namespace {

double share_below(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

// Share of a normal distribution that is cut off at both ends.
double share_of_cut(double x, double from, double to) {
  if (from > 0.0) return 1.0 - share_of_cut(-x, -to, -from);  // digits of the upper tail
  return (share_below(x) - share_below(from)) / (share_below(to) - share_below(from));
}

constexpr double kScores[] = {-6.0, -2.5, -1.0, -0.1, 0.0, 0.3, 1.0, 2.5, 6.0};

Spread of_shape(Shape shape, double centre, double width, double least, double most) {
  return {nullptr, shape, centre, width, least, most, "test"};
}

TEST(Spread, NormalIsCutAtItsEndsAndKeepsItsShares) {
  const double ends[][2] = {{-3.0, 8.0}, {2.0, 3.0}, {9.0, 30.0}, {-40.0, -6.0}, {-200.0, 200.0}};
  for (const auto& [least, most] : ends) {
    const Spread spread = of_shape(Shape::normal, 1.0, 2.0, least, most);
    for (const double z : kScores) {
      const double x = value_at(spread, z);
      EXPECT_GE(x, least);
      EXPECT_LE(x, most);
      EXPECT_NEAR(share_of_cut((x - 1.0) / 2.0, (least - 1.0) / 2.0, (most - 1.0) / 2.0), share_below(z),
                  1e-9)
          << least << " " << most << " " << z;
    }
  }
}

TEST(Spread, WithoutEndsInReachItIsTheNormalDistribution) {
  const Spread spread = of_shape(Shape::normal, 10.0, 0.5, -1e3, 1e3);
  for (const double z : kScores) EXPECT_NEAR(value_at(spread, z), 10.0 + 0.5 * z, 1e-7);
}

TEST(Spread, CensoredPutsWhatIsBeyondOnTheEnd) {
  const Spread spread = of_shape(Shape::censored_normal, 1.0, 2.0, 0.0, 3.0);
  EXPECT_EQ(value_at(spread, -0.5), 0.0);
  EXPECT_EQ(value_at(spread, -4.0), 0.0);
  EXPECT_EQ(value_at(spread, 0.25), 1.5);
  EXPECT_EQ(value_at(spread, 1.5), 3.0);
}

TEST(Spread, LognormalHasItsMedianAndShares) {
  const Spread spread = of_shape(Shape::lognormal, 4.0, 0.5, 1.0, 30.0);
  for (const double z : kScores) {
    const double x = value_at(spread, z);
    EXPECT_NEAR(share_of_cut(std::log(x / 4.0) / 0.5, std::log(1.0 / 4.0) / 0.5, std::log(30.0 / 4.0) / 0.5),
                share_below(z), 1e-9);
  }
}

TEST(Spread, UniformHasItsShares) {
  const Spread spread = of_shape(Shape::uniform, 0.0, 1.0, 2.0, 6.0);
  for (const double z : kScores) EXPECT_NEAR((value_at(spread, z) - 2.0) / 4.0, share_below(z), 1e-12);
}

TEST(Spread, AnUnknownShapeNamesTheOthers) {
  EXPECT_EQ(test::thrown<std::invalid_argument>([] { shape_of("gaussian"); }),
            "no distribution is called 'gaussian'; there are normal, censored_normal, lognormal, uniform");
}

}  // namespace
}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of the phantoms are within a hundredth of a degree of their closed forms, gaps within what is
// proven.
#include "limits/phantom.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/directions.hpp"

namespace impinge {
namespace {

TEST(Phantom, FirstTurnToAnAngleIsTheFirst) {
  const auto v = test::random_directions(30, 9);
  int found = 0;
  for (std::size_t i = 0; i + 2 < v.size(); i += 3) {
    const AngleQuestion question{v[i], v[i + 1], v[i + 2], 0.3};
    const auto off = [&](double t) {
      return (Eigen::AngleAxisd(t, question.axis) * question.turning).dot(question.fixed) - question.cosine;
    };
    const auto first = first_turn_to(question);
    const double end = first ? *first : 2.0 * kPi;
    for (int k = 1; k < 500; ++k) EXPECT_GT(off(1e-9) * off(end * k / 500.0), 0.0);
    if (!first) continue;
    ++found;
    EXPECT_NEAR(off(*first), 0.0, 1e-12);
  }
  EXPECT_GT(found, 3);
}

// With few sides, for the time it takes: the error grows with the inverse square. The experiment measures it
// at kPhantomSides.
TEST(Phantom, LimitsAreThoseOfTheClosedForms) {
  constexpr std::size_t kSides = 60;
  constexpr double kCoarser = static_cast<double>(kPhantomSides) / kSides;
  const auto rows = phantom_limits(kSides);
  EXPECT_EQ(rows.size(), 11U);
  for (const PhantomRow& row : rows)
    EXPECT_LE(std::abs(row.error), kCoarser * kCoarser * kPhantomLimitError)
        << row.phantom << ", " << row.quantity;
}

TEST(Phantom, GapsAreWithinTheirBounds) {
  const auto rows = phantom_gaps();
  EXPECT_EQ(rows.size(), 9U);
  for (const PhantomRow& row : rows) {
    EXPECT_LE(std::abs(row.error), row.bound) << row.phantom << ", " << row.quantity;
    EXPECT_LT(row.bound, 0.5) << "a bound that says something";
  }
}

}  // namespace
}  // namespace impinge

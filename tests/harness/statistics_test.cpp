// SPDX-License-Identifier: GPL-3.0-or-later
// Known answers of type 7 of Hyndman and Fan (1996), as R's quantile() and NumPy's percentile() give by
// default.
#include "harness/statistics.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "harness/equator_turn.hpp"
#include "sphere/schemes/usid.hpp"
#include "sphere/schemes/usid_arc.hpp"

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

// Three turns and nine entries, z = 1, 3/4 ... -1, so that phi = 0, 41.4, 60, 75.5, 90 ... and theta = 6 phi
// = 0, 248.5, 360, 453.1, 540, 626.9, 720, 831.5, 1080 degrees. The equator is at 540. The turn [360, 720)
// holds 360, 453.1, 540 and 626.9; [400, 760) holds 453.1 to 720; [250, 610) only 360, 453.1 and 540.
TEST(EquatorTurn, OfThreeTurnsAndNineEntriesIsCountedByHand) {
  const EquatorTurn turn = equator_turn(Usid::with_turns(3));
  EXPECT_EQ(turn.least, 3U);
  EXPECT_EQ(turn.most, 4U);
}

// Two turns and four entries at 0, 282.1, 437.9 and 720 degrees; the equator is at 360. [80, 440) holds two,
// [283, 643) one.
TEST(EquatorTurn, OfTwoTurnsAndFourEntriesIsCountedByHand) {
  const EquatorTurn turn = equator_turn(Usid::with_turns(2));
  EXPECT_EQ(turn.least, 1U);
  EXPECT_EQ(turn.most, 2U);
}

// A turn at the equator is pi / k of phi long, of which the entries take equal steps of 2 / (k^2 - 1) in z.
TEST(EquatorTurn, OfAFineHelixIsTheLengthOfATurnRoundedDownAndUp) {
  for (const std::size_t k : {50U, 229U, 458U, 1000U}) {
    const auto turns = static_cast<double>(k);
    const double entries = (turns * turns - 1.0) * std::sin(0.5 * kPi / turns);
    const EquatorTurn turn = equator_turn(Usid::with_turns(k));
    EXPECT_EQ(turn.least, static_cast<std::size_t>(entries)) << k;
    EXPECT_EQ(turn.most, static_cast<std::size_t>(entries) + 1) << k;
  }
}

// What the schemes say of themselves is the most; at a few turns the curve of z makes their formula too
// large.
TEST(EquatorTurn, OfTable6IsAtMostWhatTheSchemeSays) {
  for (const std::size_t k : {229U, 458U, 2292U, 4584U}) {
    EXPECT_EQ(equator_turn(Usid::with_turns(k)).most, Usid::with_turns(k).equator_points()) << k;
    EXPECT_EQ(equator_turn(UsidArc::with_turns(k)).most, UsidArc::with_turns(k).equator_points()) << k;
  }
  EXPECT_LT(equator_turn(Usid::with_turns(3)).most, Usid::with_turns(3).equator_points());
}

}  // namespace
}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/equator_turn.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sphere/schemes/usid.hpp"
#include "sphere/schemes/usid_arc.hpp"

namespace impinge::lab {
namespace {

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

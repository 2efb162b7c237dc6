// SPDX-License-Identifier: GPL-3.0-or-later
// What methods answer to the test set of turns, and how long they take.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "28_turns/turn_set.hpp"
#include "files/csv.hpp"

namespace impinge::lab {

inline constexpr double kTurnTolerance = 1e-6;  // radians, that an answer may be off

/// All settings of all methods that can be asked: those of methods/turns.hpp, tests of touch in steps, and
/// CGAL's exact one.
std::vector<TurnCase> turn_cases(bool quick);

/// What one setting answers to the queries of a kind and a family.
struct TurnTally {
  std::size_t queries = 0;
  std::size_t meet = 0;        // of these
  std::size_t missed = 0;      // no answer, or one too late
  std::size_t false_hits = 0;  // an answer where they do not meet
  std::size_t early = 0;       // an answer too early
  std::size_t undecided = 0;   // none up to its angle, which is not too late, and no more is said
  double largest_late = 0.0;   // radians, of answers where they meet
  double largest_early = 0.0;  // radians
  std::string missed_first;    // name of the first query that was missed

  void add(const KnownTurn& turn, const TurnAnswer& answer);
};

/// The columns of the tallies, and a row.
std::vector<Column> tally_columns();
std::vector<Cell> tally_cells(const TurnTally& tally);

}  // namespace impinge::lab

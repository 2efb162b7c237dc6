// SPDX-License-Identifier: GPL-3.0-or-later
// The answers of methods to the test set of turns, and their times.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "28_turns/turn_set.hpp"
#include "files/csv.hpp"

namespace impinge::lab {

inline constexpr double kTurnTolerance = 1e-6;  // radians by which an answer may be off

/// All settings of all methods that can answer: those of methods/turns.hpp, tests of touch in steps, CGAL's.
std::vector<TurnCase> turn_cases(bool quick);

/// The answers of one setting to the queries of one kind and family.
struct TurnTally {
  std::size_t queries = 0;
  std::size_t meet = 0;        // queries that meet
  std::size_t missed = 0;      // no answer, or one too late
  std::size_t false_hits = 0;  // an answer though they do not meet
  std::size_t early = 0;       // an answer too early
  std::size_t undecided = 0;   // no contact up to an angle that is not too late, and nothing known beyond
  double largest_late = 0.0;   // radians, of answers where they meet
  double largest_early = 0.0;  // radians
  std::string missed_first;    // name of the first query with a missed contact

  void add(const KnownTurn& turn, const TurnAnswer& answer);
};

/// The columns of the tallies, and the cells of a row.
std::vector<Column> tally_columns();
std::vector<Cell> tally_cells(const TurnTally& tally);

}  // namespace impinge::lab

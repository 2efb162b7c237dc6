// SPDX-License-Identifier: GPL-3.0-or-later
// One thing to be timed, and how often a round repeats it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "files/csv.hpp"

namespace impinge::lab {

struct TimedCase {
  // Method and settings, unique in a run: the first columns of the samples file.
  std::vector<Cell> key;
  // Compares the result with the oracle and throws on failure; empty where another case covers it.
  std::function<void()> verify;
  // The work that is timed.
  std::function<void()> run;
  // Where it is given it comes before each run, not timed: a round is then one run, which nothing warms up.
  std::function<void()> before;
  // Pieces of work in one run, such as poses: times are given for one of them.
  double units = 1.0;
  int rounds = 15;  // samples that are taken
  // Above 0: known to take so many seconds, so it is neither warmed up nor calibrated; one run a round.
  double expected_s = 0.0;
};

// How long a round takes, when a result says nothing, and how often it is then asked again.
struct TimingOptions {
  double min_round_ms = 20.0;     // fast cases repeat within a round until it takes so long
  double slow_ms = 1000.0;        // a run that takes longer is not repeated and not warmed up within a round
  double max_control_off = 0.02;  // largest |ratio - 1| of the control
  double max_spread = 0.10;       // largest IQR as a share of the median
  int most_repeats = 3;           // times that an inconclusive timing is repeated, alone
  double repeat_share = 0.25;     // all repeats take at most this share of the time of the run ...
  double least_repeat_s = 10.0;   // ... or so many seconds, where that is more
};

// The parts of a key with a slash between them.
std::string key_text(const std::vector<Cell>& key);

// What makes a run cold: it writes a block of so many bytes, more than the caches hold. Copies share the
// block.
std::function<void()> overwrite_caches(std::size_t bytes);

// Throws std::invalid_argument for a case without work, units or rounds and for a key used twice.
void check_cases(const std::vector<TimedCase>& cases);

// A case ready to run: how often within a round, and how long that will take.
struct RoundPlan {
  const TimedCase* work = nullptr;  // borrowed
  std::string name;                 // text of the key
  std::int64_t batch = 1;           // runs within a round
  double run_s = 0.0;               // seconds a run
  bool warm_up = false;             // one more run, not timed, begins each round
  double before_s = 0.0;            // seconds of what comes before a run

  // Seconds that a round takes.
  double round_s() const { return before_s + run_s * (static_cast<double>(batch) + (warm_up ? 1.0 : 0.0)); }
};

// Warms the case up and finds the batch. The case must outlive the plan.
RoundPlan plan_rounds(const TimedCase& work, const TimingOptions& options);

}  // namespace impinge::lab

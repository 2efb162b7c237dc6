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
  // If given, is called before each run, untimed; a round is then one run, without warm-up.
  std::function<void()> before;
  // Pieces of work in one run, such as poses: times are given for one of them.
  double units = 1.0;
  int rounds = 15;  // samples that are taken
  // If above 0: seconds that a run is known to take; it is neither warmed up nor calibrated, one run a round.
  double expected_s = 0.0;
};

// How long a round takes, when a timing is inconclusive, and how often it is then repeated.
struct TimingOptions {
  double min_round_ms = 20.0;     // fast cases repeat within a round until it takes so long
  double slow_ms = 1000.0;        // a run that takes longer is neither repeated nor warmed up in a round
  double max_control_off = 0.02;  // largest |ratio - 1| of the control
  double max_spread = 0.10;       // largest IQR as a share of the median
  int most_repeats = 3;           // times that an inconclusive timing is repeated, alone
  double repeat_share = 0.25;     // all repeats take at most this share of the time of the run ...
  double least_repeat_s = 10.0;   // ... or so many seconds, where that is more
};

// The parts of a key with a slash between them.
std::string key_text(const std::vector<Cell>& key);

// A function that empties the caches before a cold run: it writes a block of so many bytes, which should be
// more than the caches hold. Copies share the block.
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
  double before_s = 0.0;            // seconds of TimedCase::before

  // Seconds that a round takes.
  double round_s() const { return before_s + run_s * (static_cast<double>(batch) + (warm_up ? 1.0 : 0.0)); }
};

// Warms the case up and finds how often it runs in a round. The case must outlive the plan.
RoundPlan plan_rounds(const TimedCase& work, const TimingOptions& options);

}  // namespace impinge::lab

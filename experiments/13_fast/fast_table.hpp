// SPDX-License-Identifier: GPL-3.0-or-later
// The table that experiment 13 fills.
#pragma once

#include <vector>

#include "13_fast/fast_errors.hpp"
#include "harness/timing.hpp"

namespace impinge::lab {

// What is said of a case beside its time.
struct FastCase {
  TimedCase timed;                    // its key is fast_keys()
  FastErrors errors;                  // of the same method
  double bytes = 0.0;                 // of table or tree
  Measure measure = Measure::radial;  // what the errors are of
};

// method, setting, storage, triangles, direction, instruction_set, threads, state.
std::vector<Column> fast_keys();

// A row a case, in their order, which is that of the timings.
Table fast_table(const std::vector<FastCase>& cases, const TimingRun& run);

}  // namespace impinge::lab

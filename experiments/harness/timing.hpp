// SPDX-License-Identifier: GPL-3.0-or-later
// The timing protocol, on Google Benchmark: every case is verified before anything is timed; the rounds of
// all cases run in one random order, so that a slow spell of the machine hits all of them; each round of a
// fast case starts warm, unless the case asks for cold runs; every sample is kept; the fastest case runs
// twice under two names, and the ratio of the two medians (A/A control) shows the noise of the run.
// Inconclusive cases are then timed again, alone (harness/timing_repeats.hpp). Wall clock, one thread.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/progress.hpp"
#include "harness/statistics.hpp"
#include "harness/timed_case.hpp"

namespace impinge::lab {

// Samples of one case, milliseconds a unit, in the order of its rounds.
struct Timing {
  std::vector<Cell> key;           // of the case
  std::vector<double> samples_ms;  // one a round
  Summary summary;                 // of the samples
  std::int64_t batch = 1;          // runs within a round
  int repeats = 0;                 // how often it was timed again, alone; the samples are of the last time
  bool inconclusive = false;       // see is_inconclusive()
};

// All samples of a run, and its control.
struct TimingRun {
  std::vector<Timing> timings;  // in the order of the cases
  Timing control;               // the second registration of the control case
  double control_ratio = 1.0;   // its median over the median of the first
  TimingOptions options;        // that it was run with
};

// Is a timing too noisy to use? So if the control of its run is off, its spread is too large, or it has only
// one round, which gives no spread.
bool is_inconclusive(const Timing& timing, double control_ratio, const TimingOptions& options);

// Adds the timings of another run with the same options; keeps the control that is farther off.
void append(TimingRun& all, TimingRun more);

// The timing of work that is `factor` times as much: samples, median and spread times the factor.
Timing scaled(Timing timing, double factor);

// The timing of a case. Throws std::out_of_range for a key that was not measured.
const Timing& find(const TimingRun& run, const std::vector<Cell>& key);

// Verifies, warms up, times, and repeats what is inconclusive. Throws std::invalid_argument for bad cases
// (see check_cases); whatever verify or run throws ends the measurement. IMPINGE_ROUNDS of the environment is
// the largest number of rounds, without repeats: for tests of all but the times.
TimingRun run_interleaved(const std::vector<TimedCase>& cases, const TimingOptions& options,
                          Progress& progress);

}  // namespace impinge::lab

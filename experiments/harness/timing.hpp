// SPDX-License-Identifier: GPL-3.0-or-later
// The timing protocol, on Google Benchmark: every case is verified before anything is timed; the rounds of
// all cases run in one random order, so that a slow spell of the machine hits all of them; each round of a
// fast case starts warm, unless the case asks for cold runs; every sample is kept; the fastest case runs
// twice under two names, and the ratio of the two medians (A/A control) shows the noise of the run.
// Inconclusive cases are then timed again, alone (repeat_inconclusive()). Wall clock, one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "files/csv.hpp"
#include "harness/driver.hpp"
#include "harness/statistics.hpp"

namespace impinge::lab {

// One thing to be timed, and how often a round repeats it.
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

// Times inconclusive cases of a run again, each alone, so that no other case disturbs its caches.

// What repeats may cost, and the functions that make them (replaced in tests).
struct RepeatMeans {
  double budget_s = 0.0;                             // for all repeats together
  std::function<TimingRun(const TimedCase&)> alone;  // a run of this case and its control, nothing else
  std::function<double()> elapsed_s;                 // since the first repeat could begin
};

// Fewest rounds of a repeat: one has no spread, and two tell little about it.
inline constexpr int kLeastRepeatRounds = 3;

// Times each inconclusive timing of the run again, the cheapest first, up to options.most_repeats times,
// until it is conclusive by its own control and spread. The last timing is kept, conclusive or not. A repeat
// that is not expected to end within the budget is not begun.
void repeat_inconclusive(TimingRun& run, const std::vector<TimedCase>& cases, const RepeatMeans& means,
                         Progress& progress);

// How timings enter the results: a table of medians, the raw samples and a record of the protocol.

// The given columns for the keys of the cases, then median_ms, iqr_ms, rounds, extrapolated, inconclusive and
// repeats.
std::vector<Column> timing_columns(std::vector<Column> key_columns);

// Cells of such a row for a timing that is not extrapolated.
std::vector<Cell> timing_cells(const Timing& timing);

// A table of these columns, one row a case, with one more column median_ns: the median in nanoseconds.
Table medians_in_ns(std::vector<Column> key_columns, const TimingRun& run, const std::string& unit);

// Cells of an extrapolated row: its key, and the timing of a smaller measurement, already scaled.
std::vector<Cell> extrapolated_cells(std::vector<Cell> key, const Timing& scaled);

// One row a round: the key of the case under the given columns, then round (from 1) and ms (a unit of work).
Table samples_table(std::vector<Column> key_columns, const TimingRun& run);

// For the sidecar: protocol, batch of each case, control case with its samples and ratio, repeated and
// inconclusive cases.
nlohmann::json timing_record(const TimingRun& run);

// Writes the result with its record of timing, then the samples behind it as NAME_samples, and warns of every
// case that is inconclusive.
void write_timed(DriverRun& driver, Result result, const std::vector<Column>& key_columns,
                 const TimingRun& run);

}  // namespace impinge::lab

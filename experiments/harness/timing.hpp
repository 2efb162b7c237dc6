// SPDX-License-Identifier: GPL-3.0-or-later
// The timing protocol, on Google Benchmark. Every case is verified before anything is timed. The rounds of
// all cases run in one random order, so that a slow spell of the machine affects all of them. Each round of a
// fast case starts warm, unless the case asks for cold runs. Every sample is kept. The fastest case runs
// twice under two names; the ratio of the two medians (A/A control) shows the noise of the run. Inconclusive
// cases are then timed again, alone (repeat_inconclusive()). Wall clock, one thread.
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

// A case to be timed, and how often a round repeats it.
struct TimedCase {
  // Method and settings, unique in a run: the first columns of the samples file.
  std::vector<Cell> key;
  // Compares the result with the oracle and throws if they differ; empty if another case covers it.
  std::function<void()> verify;
  // The work that is timed.
  std::function<void()> run;
  // Called before each run, untimed. A round is then one run, without warm-up.
  std::function<void()> before;
  // Pieces of work in one run, such as poses; times are given per piece.
  double units = 1.0;
  int rounds = 15;  // samples that are taken
  // Seconds that a run is known to take. If above 0, a round is one run, without warm-up and calibration.
  double expected_s = 0.0;
};

// How long a round takes, which timings are inconclusive, and how often these are repeated.
struct TimingOptions {
  double min_round_ms = 20.0;     // fast cases repeat within a round until it takes this long
  double slow_ms = 1000.0;        // longer runs are not repeated or warmed up within a round
  double max_control_off = 0.02;  // largest |ratio - 1| of the control
  double max_spread = 0.10;       // largest IQR as a share of the median
  int most_repeats = 3;           // times that an inconclusive timing is repeated alone
  double repeat_share = 0.25;     // all repeats take at most this share of the run's time ...
  double least_repeat_s = 10.0;   // ... or this many seconds if that is more
};

// The parts of a key, separated by slashes.
std::string key_text(const std::vector<Cell>& key);

// A function that empties the caches before a cold run, by writing a block of so many bytes; the block should
// be larger than the caches. Copies share the block.
std::function<void()> overwrite_caches(std::size_t bytes);

// Throws std::invalid_argument for a case without work, units or rounds, and for a key that is used twice.
void check_cases(const std::vector<TimedCase>& cases);

// A prepared case: how often it runs within a round, and how long that takes.
struct RoundPlan {
  const TimedCase* work = nullptr;  // borrowed
  std::string name;                 // key as text
  std::int64_t batch = 1;           // runs within a round
  double run_s = 0.0;               // seconds per run
  bool warm_up = false;             // does one untimed run begin each round?
  double before_s = 0.0;            // seconds of TimedCase::before

  // Seconds that a round takes.
  double round_s() const { return before_s + run_s * (static_cast<double>(batch) + (warm_up ? 1.0 : 0.0)); }
};

// Warms the case up and finds how often it runs in a round. The case must outlive the plan.
RoundPlan plan_rounds(const TimedCase& work, const TimingOptions& options);

// Samples of one case, milliseconds per unit, in the order of its rounds.
struct Timing {
  std::vector<Cell> key;           // of the case
  std::vector<double> samples_ms;  // one per round
  Summary summary;                 // of the samples
  std::int64_t batch = 1;          // runs within a round
  int repeats = 0;                 // how often it was timed again; the samples are of the last time
  bool inconclusive = false;       // see is_inconclusive()
};

// All samples of a run, and its control.
struct TimingRun {
  std::vector<Timing> timings;  // in the order of the cases
  Timing control;               // the second run of the control case
  double control_ratio = 1.0;   // its median divided by the median of the first
  TimingOptions options;        // options of the run
};

// Is a timing too noisy to use? It is if the control of its run is off, if its spread is too large, or if it
// has only one round, which gives no spread.
bool is_inconclusive(const Timing& timing, double control_ratio, const TimingOptions& options);

// Adds the timings of another run with the same options. Of the two controls it keeps the worse.
void append(TimingRun& all, TimingRun more);

// The timing of `factor` times as much work: samples, median and spread times the factor.
Timing scaled(Timing timing, double factor);

// The timing of a case. Throws std::out_of_range for a key that was not measured.
const Timing& find(const TimingRun& run, const std::vector<Cell>& key);

// Verifies, warms up, times, and repeats inconclusive cases. Throws std::invalid_argument for bad cases
// (check_cases()), and whatever verify or run throws. The variable IMPINGE_ROUNDS limits the number of rounds
// and prevents repeats: for tests of everything but the times.
TimingRun run_interleaved(const std::vector<TimedCase>& cases, const TimingOptions& options,
                          Progress& progress);

// Times inconclusive cases again, each alone, so that no other case disturbs its caches.

// The budget of repeats, and the functions that make them (replaced in tests).
struct RepeatMeans {
  double budget_s = 0.0;                             // for all repeats together
  std::function<TimingRun(const TimedCase&)> alone;  // runs this case and its control, nothing else
  std::function<double()> elapsed_s;                 // since the repeats began
};

// Fewest rounds of a repeat: one round has no spread, and two say little about it.
inline constexpr int kLeastRepeatRounds = 3;

// Repeats each inconclusive timing, the cheapest first, up to options.most_repeats times, until its own
// control and spread are conclusive. The last timing is kept, conclusive or not. A repeat is not begun if it
// is not expected to end within the budget.
void repeat_inconclusive(TimingRun& run, const std::vector<TimedCase>& cases, const RepeatMeans& means,
                         Progress& progress);

// Timings in the results: a table of medians, the raw samples, and a record of the protocol.

// The key columns, then median_ms, iqr_ms, rounds, extrapolated, inconclusive and repeats.
std::vector<Column> timing_columns(std::vector<Column> key_columns);

// The cells of a timing that is not extrapolated.
std::vector<Cell> timing_cells(const Timing& timing);

// A table with these columns and median_ns, the median in nanoseconds; one row per case.
Table medians_in_ns(std::vector<Column> key_columns, const TimingRun& run, const std::string& unit);

// The cells of an extrapolated row: its key, and the timing of a smaller measurement, already scaled.
std::vector<Cell> extrapolated_cells(std::vector<Cell> key, const Timing& scaled);

// One row per round: the key columns, then round (from 1) and ms (per unit of work).
Table samples_table(std::vector<Column> key_columns, const TimingRun& run);

// For the sidecar: protocol, batch of each case, control case with its samples and ratio, repeated and
// inconclusive cases.
nlohmann::json timing_record(const TimingRun& run);

// Writes the result with its record of timing, then its samples as NAME_samples, and warns of every
// inconclusive case.
void write_timed(DriverRun& driver, Result result, const std::vector<Column>& key_columns,
                 const TimingRun& run);

}  // namespace impinge::lab

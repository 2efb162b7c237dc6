// SPDX-License-Identifier: GPL-3.0-or-later
// What the harness does is counted; how long it takes is never asserted.
#include "harness/timing.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "harness/timing.hpp"
#include "support/thrown.hpp"

namespace impinge::lab {
namespace {

// Cases that note each call of theirs.
struct Log {
  std::vector<std::string> calls;

  TimedCase make(const std::string& name, int rounds) {
    TimedCase timed;
    timed.key = {name, 3000};
    timed.rounds = rounds;
    timed.expected_s = 1e-6;  // neither warmed up nor repeated: one call a round
    timed.verify = [this, name] { calls.push_back("verify " + name); };
    timed.run = [this, name] { calls.push_back(name); };
    return timed;
  }
  long count(const std::string& name) const { return std::count(calls.begin(), calls.end(), name); }
};

// Work of no length is never steady: without repeats its calls can be counted.
TimingOptions once() {
  TimingOptions options;
  options.most_repeats = 0;
  return options;
}

TimingRun time_all(const std::vector<TimedCase>& cases, const TimingOptions& options = once()) {
  Progress silent("test", nullptr);
  return run_interleaved(cases, options, silent);
}

TEST(Timing, RunsEachCaseOnceARoundAndTheControlTwice) {
  Log log;
  const TimingRun run = time_all({log.make("a", 7), log.make("b", 4)});
  ASSERT_EQ(run.timings.size(), 2U);
  EXPECT_EQ(run.timings[0].samples_ms.size(), 7U);
  EXPECT_EQ(run.timings[1].samples_ms.size(), 4U);
  EXPECT_EQ(run.timings[0].summary.count, 7U);
  const long control_rounds = static_cast<long>(run.control.samples_ms.size());
  const bool a_is_control = key_text(run.control.key) == "a/3000";
  EXPECT_EQ(control_rounds, a_is_control ? 7 : 4);
  EXPECT_EQ(log.count("a"), 7 + (a_is_control ? control_rounds : 0));
  EXPECT_EQ(log.count("b"), 4 + (a_is_control ? 0 : control_rounds));
}

TEST(Timing, HasTheRoundsOfTheEnvironmentAtMostAndNoRepeats) {
  Log log;
  ASSERT_EQ(setenv("IMPINGE_ROUNDS", "2", 1), 0);
  const TimingRun run = time_all({log.make("a", 7), log.make("b", 1)}, {});
  ASSERT_EQ(unsetenv("IMPINGE_ROUNDS"), 0);
  ASSERT_EQ(run.timings.size(), 2U);
  EXPECT_EQ(run.timings[0].samples_ms.size(), 2U);
  EXPECT_EQ(run.timings[1].samples_ms.size(), 1U);
  EXPECT_EQ(run.timings[1].repeats, 0);
  EXPECT_EQ(run.options.most_repeats, 0);
  EXPECT_EQ(time_all({log.make("c", 3)}).timings[0].samples_ms.size(), 3U);
}

TEST(Timing, InterleavesTheRounds) {
  Log log;
  time_all({log.make("a", 40), log.make("b", 40)});
  long changes = 0;
  for (std::size_t i = 1; i < log.calls.size(); ++i) changes += log.calls[i] != log.calls[i - 1] ? 1 : 0;
  // One block after the other has 3 changes, verification and control included. A random order of 120 has 53
  // in the mean; fewer than 20 happen less than once in 1e9 runs.
  EXPECT_GT(changes, 20);
}

TEST(Timing, VerifiesAllBeforeAnythingRuns) {
  Log log;
  time_all({log.make("a", 2), log.make("b", 2)});
  ASSERT_GE(log.calls.size(), 2U);
  EXPECT_EQ(log.calls[0], "verify a");
  EXPECT_EQ(log.calls[1], "verify b");
  EXPECT_EQ(log.count("verify a"), 1);
}

TEST(Timing, FailedVerificationStopsTheRunAndNamesTheCase) {
  Log log;
  std::vector<TimedCase> cases{log.make("a", 2), log.make("b", 2)};
  cases[1].verify = [] { throw std::runtime_error("radius is off by 3 mm"); };
  EXPECT_EQ(test::thrown<std::runtime_error>([&] { time_all(cases); }), "b/3000: radius is off by 3 mm");
  EXPECT_EQ(log.count("a"), 0);
}

TEST(Timing, WhatTheWorkThrowsEndsTheRunAndTheHarnessIsUsableAgain) {
  Log log;
  std::vector<TimedCase> cases{log.make("a", 3), log.make("b", 3)};
  cases[0].run = [] { throw std::length_error("no memory for the table"); };
  EXPECT_THROW(time_all(cases), std::length_error);
  const TimingRun run = time_all({log.make("c", 3)});
  EXPECT_EQ(run.timings.at(0).samples_ms.size(), 3U);
}

// Before each run, and not timed: what takes long there does not show, and every run of a round has its own.
TEST(Timing, WhatComesBeforeARunIsNotTimed) {
  Log log;
  TimedCase cold = log.make("cold", 6);
  cold.expected_s = 0.0;
  cold.before = [&log] {
    const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(5);
    while (std::chrono::steady_clock::now() < until) {
    }
    log.calls.emplace_back("before");
  };
  const TimingRun run = time_all({cold, log.make("b", 6)});
  EXPECT_EQ(log.count("cold"), 7) << "six rounds and one to know its time";
  EXPECT_EQ(log.count("before"), 7);
  for (std::size_t i = 1; i < log.calls.size(); ++i) {
    if (log.calls[i] != "cold") continue;
    EXPECT_EQ(log.calls[i - 1], "before");
  }
  EXPECT_EQ(run.timings[0].batch, 1);
  EXPECT_LT(run.timings[0].summary.median, 5.0) << "what comes before takes 5 ms";
  EXPECT_EQ(key_text(run.control.key), "b/3000") << "one that can be steady";
}

TEST(Timing, RunsAreJoinedWithTheWorseControl) {
  Log log;
  TimingRun all;
  append(all, {});
  TimingRun good = time_all({log.make("a", 2)});
  TimingRun bad = time_all({log.make("b", 2)});
  good.control_ratio = 1.01;
  bad.control_ratio = 0.9;
  append(all, good);
  append(all, bad);
  append(all, good);
  ASSERT_EQ(all.timings.size(), 3U);
  EXPECT_EQ(key_text(all.timings[1].key), "b/3000");
  EXPECT_EQ(all.control_ratio, 0.9);
  EXPECT_EQ(key_text(all.control.key), "b/3000");
}

TEST(Timing, FastWorkIsRepeatedWithinARoundAndTimesAreForOneUnit) {
  long calls = 0;
  TimedCase timed;
  timed.key = {"fast"};
  timed.rounds = 3;
  timed.units = 4.0;
  timed.run = [&calls] { ++calls; };
  TimingOptions options = once();
  options.min_round_ms = 0.01;
  const TimingRun run = time_all({timed}, options);
  EXPECT_GT(run.timings[0].batch, 1);
  EXPECT_GT(calls,
            2L * 3L * run.timings[0].batch);  // both registrations, a warm-up each round, and the calibration
  timed.units = 4e6;
  EXPECT_LT(time_all({timed}, options).timings[0].summary.median, run.timings[0].summary.median);
}

TEST(Timing, RefusesCasesThatCannotBeTimed) {
  Log log;
  EXPECT_THROW(time_all({log.make("a", 0)}), std::invalid_argument);
  EXPECT_THROW(time_all({log.make("a", 1), log.make("a", 1)}), std::invalid_argument);
  TimedCase idle = log.make("b", 1);
  idle.run = nullptr;
  EXPECT_THROW(time_all({idle}), std::invalid_argument);
  EXPECT_TRUE(log.calls.empty());
}

TEST(Timing, FindsATimingByItsKey) {
  Log log;
  const TimingRun run = time_all({log.make("a", 1), log.make("b", 2)});
  EXPECT_EQ(find(run, {"b", 3000}).samples_ms.size(), 2U);
  EXPECT_THROW(find(run, {"b", 12000}), std::out_of_range);
}

Timing timing_of(std::vector<double> samples) {
  Timing timing;
  timing.summary = summarise(samples);
  timing.samples_ms = std::move(samples);
  return timing;
}

// Noise verdicts on synthetic samples.
TEST(Timing, IsInconclusiveWhenTheControlIsOffOrTheSpreadIsLarge) {
  const Timing steady = timing_of({1.00, 1.01, 1.02, 1.03, 1.04});
  const Timing noisy = timing_of({1.0, 1.1, 1.2, 1.3, 1.4});
  EXPECT_FALSE(is_inconclusive(steady, 1.0, {}));
  EXPECT_TRUE(is_inconclusive(noisy, 1.0, {}));
  for (const double ratio : {0.979, 1.021}) EXPECT_TRUE(is_inconclusive(steady, ratio, {})) << ratio;
  for (const double ratio : {0.981, 1.019}) EXPECT_FALSE(is_inconclusive(steady, ratio, {})) << ratio;
}

TEST(Timing, OneRoundHasNoSpreadAndIsInconclusive) {
  EXPECT_TRUE(is_inconclusive(timing_of({1.0}), 1.0, {}));
  EXPECT_FALSE(is_inconclusive(timing_of({1.0, 1.0}), 1.0, {}));
  Log log;
  TimingOptions options = once();
  options.max_control_off = 1e9;
  EXPECT_TRUE(time_all({log.make("a", 1)}, options).timings[0].inconclusive);
}

// A case whose spread no machine can pass is timed again, alone, as often as the rule says, with its control,
// and never verified twice.
TEST(Timing, ARunRepeatsWhatIsInconclusive) {
  Log log;
  TimingOptions options;
  options.max_spread = -1.0;
  const TimingRun run = time_all({log.make("a", 4), log.make("b", 4)}, options);
  for (const Timing& timing : run.timings) {
    EXPECT_TRUE(timing.inconclusive);
    EXPECT_EQ(timing.repeats, 3);
    EXPECT_EQ(timing.samples_ms.size(), 4U);
  }
  EXPECT_EQ(log.count("a") + log.count("b"), 3 * 4 + 2 * 3 * 2 * 4);
  EXPECT_EQ(log.count("verify a"), 1);
}

TEST(Timing, ScalesSamplesMedianAndSpread) {
  const Timing twice = scaled(timing_of({1.0, 2.0, 4.0}), 2.0);
  EXPECT_EQ(twice.samples_ms, (std::vector<double>{2.0, 4.0, 8.0}));
  EXPECT_EQ(twice.summary.median, 4.0);
  EXPECT_EQ(twice.summary.iqr, 3.0);
  EXPECT_EQ(twice.summary.count, 3U);
}

// Two cases with known samples; the control differs from the first by 1 %.
TimingRun known_run() {
  TimingRun run;
  for (const auto& [name, samples] : {std::pair<const char*, std::vector<double>>{"rsid", {2.0, 2.0, 2.0}},
                                      {"pairwise", {10.0, 20.0, 30.0}}}) {
    Timing timing;
    timing.key = {name, 3000};
    timing.samples_ms = samples;
    timing.summary = summarise(samples);
    timing.batch = 8;
    timing.inconclusive = name == std::string("pairwise");
    timing.repeats = timing.inconclusive ? 3 : 0;
    run.timings.push_back(timing);
  }
  run.control = run.timings[0];
  run.control_ratio = 1.01;
  return run;
}

TEST(TimingReport, KeepsEverySample) {
  const Table table = samples_table({{"method", "", ""}, {"triangles", "1", ""}}, known_run());
  EXPECT_EQ(to_csv(table),
            "method,triangles,round,ms\nrsid,3000,1,2\nrsid,3000,2,2\nrsid,3000,3,2\n"
            "pairwise,3000,1,10\npairwise,3000,2,20\npairwise,3000,3,30\n");
}

TEST(TimingReport, RowsHaveTheColumnsOfTheContract) {
  Table table{timing_columns({{"method", "", ""}, {"triangles", "1", ""}}), {}};
  table.add_row(timing_cells(known_run().timings[1]));
  table.add_row(extrapolated_cells({"pairwise", 12000}, scaled(known_run().timings[1], 16.0)));
  EXPECT_EQ(to_csv(table),
            "method,triangles,median_ms,iqr_ms,rounds,extrapolated,inconclusive,repeats\n"
            "pairwise,3000,20,10,3,no,yes,3\npairwise,12000,320,160,3,yes,yes,3\n");
}

// A unit of work once more in nanoseconds: a million a millisecond.
TEST(TimingReport, MediansAreInNanosecondsToo) {
  const Table table = medians_in_ns({{"method", "", ""}, {"triangles", "1", ""}}, known_run(), "look-up");
  EXPECT_EQ(to_csv(table),
            "method,triangles,median_ms,iqr_ms,rounds,extrapolated,inconclusive,repeats,median_ns\n"
            "rsid,3000,2,0,3,no,no,0,2e+06\npairwise,3000,20,10,3,no,yes,3,2e+07\n");
  EXPECT_EQ(table.columns.back().meaning, "the median for one look-up");
}

TEST(TimingReport, RecordsControlAndInconclusiveCases) {
  const nlohmann::json record = timing_record(known_run());
  EXPECT_EQ(record["control"]["case"], "rsid/3000");
  EXPECT_DOUBLE_EQ(record["control"]["ratio"].get<double>(), 1.01);
  EXPECT_EQ(record["control"]["samples_ms"].size(), 3U);
  EXPECT_EQ(record["inconclusive"], nlohmann::json::array({"pairwise/3000"}));
  EXPECT_EQ(record["repeats"], (nlohmann::json{{"pairwise/3000", 3}}));
  EXPECT_EQ(record["batch"]["rsid/3000"], 8);
}

}  // namespace
}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "files/stopwatch.hpp"
#include "harness/timing.hpp"

namespace impinge::lab {
namespace {

// A line for the cases that stay inconclusive.
void warn_if_inconclusive(const TimingRun& run, Progress& progress) {
  std::string doubtful;
  for (const Timing& timing : run.timings) {
    if (timing.inconclusive) doubtful.append(" ").append(key_text(timing.key));
  }
  if (doubtful.empty()) return;
  const long off = std::lround(100.0 * std::abs(run.control_ratio - 1.0));
  progress.say("warning: inconclusive (spread too large, one round, or a control that differs from itself; " +
               key_text(run.control.key) + " by " + std::to_string(off) +
               " %), time again on an idle machine:" + doubtful);
}

std::vector<Cell> cells_of(std::vector<Cell> key, const Timing& timing, bool extrapolated) {
  key.insert(key.end(), {timing.summary.median, timing.summary.iqr, timing.summary.count, extrapolated,
                         timing.inconclusive, timing.repeats});
  return key;
}

constexpr double kSeconds = 1e-3;  // in a millisecond

TimedCase with_enough_rounds(TimedCase work) {
  work.rounds = std::max(work.rounds, kLeastRepeatRounds);
  return work;
}

// Seconds that a repeat will take, with as many rounds for its control.
double repeat_s(const Timing& timing, const TimedCase& work) {
  const double run_s = kSeconds * timing.summary.median * work.units;
  return 2.0 * work.rounds * static_cast<double>(timing.batch) * run_s;
}

void repeat(Timing& timing, const TimedCase& work, int most, const RepeatMeans& means) {
  while (timing.inconclusive && timing.repeats < most) {
    if (means.elapsed_s() + repeat_s(timing, work) > means.budget_s) return;
    const int repeats = timing.repeats + 1;
    timing = means.alone(work).timings.front();
    timing.repeats = repeats;
  }
}

constexpr std::size_t kCacheLine = 64;  // bytes

double seconds_of(const std::function<void()>& run, std::int64_t times) {
  Stopwatch watch;
  for (std::int64_t i = 0; i < times; ++i) run();
  return watch.lap_s();
}

}  // namespace

std::vector<Column> timing_columns(std::vector<Column> key_columns) {
  key_columns.push_back({"median_ms", "ms", "median over the rounds, wall clock"});
  key_columns.push_back({"iqr_ms", "ms", "interquartile range over the rounds"});
  key_columns.push_back({"rounds", "1", "rounds measured"});
  key_columns.push_back({"extrapolated", "",
                         "yes: median and range are scaled from a smaller measurement, see the parameters"});
  key_columns.push_back({"inconclusive", "",
                         "yes: the time says nothing, since its spread or that of its run's control is too "
                         "large, or it has one round; repeats included"});
  key_columns.push_back({"repeats", "1", "times that it was timed again, alone, as it was inconclusive"});
  return key_columns;
}

std::vector<Cell> timing_cells(const Timing& timing) { return cells_of(timing.key, timing, false); }

Table medians_in_ns(std::vector<Column> key_columns, const TimingRun& run, const std::string& unit) {
  constexpr double kNanoseconds = 1e6;  // in a millisecond
  Table table{timing_columns(std::move(key_columns)), {}};
  table.columns.push_back({"median_ns", "ns", "the median for one " + unit});
  for (const Timing& timing : run.timings) {
    std::vector<Cell> row = timing_cells(timing);
    row.emplace_back(kNanoseconds * timing.summary.median);
    table.add_row(std::move(row));
  }
  return table;
}

std::vector<Cell> extrapolated_cells(std::vector<Cell> key, const Timing& scaled) {
  return cells_of(std::move(key), scaled, true);
}

Table samples_table(std::vector<Column> key_columns, const TimingRun& run) {
  Table table{std::move(key_columns), {}};
  table.columns.push_back({"round", "1", "number of the round of this case, in the order of measurement"});
  table.columns.push_back({"ms", "ms", "wall clock of one unit of work in this round"});
  for (const Timing& timing : run.timings) {
    for (std::size_t i = 0; i < timing.samples_ms.size(); ++i) {
      std::vector<Cell> row = timing.key;
      row.emplace_back(i + 1);
      row.emplace_back(timing.samples_ms[i]);
      table.add_row(std::move(row));
    }
  }
  return table;
}

nlohmann::json timing_record(const TimingRun& run) {
  nlohmann::json record;
  record["harness"] =
      "Google Benchmark, random interleaving of the rounds of all cases, real time, one thread";
  record["min_round_ms"] = run.options.min_round_ms;
  record["warm"] =
      "each round of a case under slow_ms begins with one run that is not timed; slower cases run as they "
      "come";
  record["cold"] = "a case that is asked so: each run is timed alone, after memory was written";
  record["slow_ms"] = run.options.slow_ms;
  record["batch"] = nlohmann::json::object();
  record["inconclusive"] = nlohmann::json::array();
  record["repeats"] = nlohmann::json::object();
  for (const Timing& timing : run.timings) {
    record["batch"][key_text(timing.key)] = timing.batch;
    if (timing.inconclusive) record["inconclusive"].push_back(key_text(timing.key));
    if (timing.repeats > 0) record["repeats"][key_text(timing.key)] = timing.repeats;
  }
  record["inconclusive_if"] = {{"control_off_by_more_than", run.options.max_control_off},
                               {"iqr_over_median_above", run.options.max_spread},
                               {"rounds_below", 2}};
  record["repeated"] = {{"at_most", run.options.most_repeats},
                        {"share_of_the_run", run.options.repeat_share},
                        {"or_seconds", run.options.least_repeat_s},
                        {"how", "alone, with a control of its own; the last time counts"}};
  record["control"] = {{"case", key_text(run.control.key)},
                       {"ratio", run.control_ratio},
                       {"samples_ms", run.control.samples_ms}};
  return record;
}

void write_timed(DriverRun& driver, Result result, const std::vector<Column>& key_columns,
                 const TimingRun& run) {
  result.timing = timing_record(run);
  driver.write(result);
  Result samples = result;
  samples.name += "_samples";
  samples.question = "Which samples are behind " + result.name + "?";
  samples.table = samples_table(key_columns, run);
  driver.write(samples);
  warn_if_inconclusive(run, driver.progress);
}

void repeat_inconclusive(TimingRun& run, const std::vector<TimedCase>& cases, const RepeatMeans& means,
                         Progress& progress) {
  std::vector<std::size_t> doubtful;
  std::vector<double> cost_s;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (run.timings[i].inconclusive) doubtful.push_back(i);
    cost_s.push_back(repeat_s(run.timings[i], with_enough_rounds(cases[i])));
  }
  if (doubtful.empty() || run.options.most_repeats < 1) return;
  progress.say("timing " + std::to_string(doubtful.size()) + " inconclusive cases again, each alone");
  std::ranges::stable_sort(doubtful, {}, [&](std::size_t i) { return cost_s[i]; });
  for (const std::size_t i : doubtful)
    repeat(run.timings[i], with_enough_rounds(cases[i]), run.options.most_repeats, means);
}

std::string key_text(const std::vector<Cell>& key) {
  std::string text;
  for (const Cell& part : key) {
    if (!text.empty()) text += '/';
    text += part.text();
  }
  return text;
}

std::function<void()> overwrite_caches(std::size_t bytes) {
  return [block = std::make_shared<std::vector<char>>(bytes)] {
    for (std::size_t i = 0; i < block->size(); i += kCacheLine) ++(*block)[i];
    benchmark::DoNotOptimize(block->data());
    benchmark::ClobberMemory();
  };
}

void check_cases(const std::vector<TimedCase>& cases) {
  std::set<std::string> names;
  for (const TimedCase& work : cases) {
    const std::string name = key_text(work.key);
    if (!names.insert(name).second) throw std::invalid_argument(name + ": two timed cases have this key");
    if (!work.run || work.rounds < 1 || !(work.units > 0.0)) {
      throw std::invalid_argument(name + ": a timed case needs work, units and at least one round");
    }
  }
}

RoundPlan plan_rounds(const TimedCase& work, const TimingOptions& options) {
  RoundPlan plan{&work, key_text(work.key), 1, work.expected_s};
  if (work.before) plan.before_s = seconds_of(work.before, 1);
  if (work.expected_s > 0.0) return plan;
  const double enough = options.min_round_ms / 1000.0;
  double seconds = seconds_of(work.run, 1);
  if (work.before) {
    plan.run_s = seconds;
    return plan;
  }
  if (1000.0 * seconds < options.slow_ms) seconds = seconds_of(work.run, 1);  // the first run was cold
  while (seconds < enough && plan.batch < (std::int64_t{1} << 40)) {
    const double factor = std::clamp(1.2 * enough / std::max(seconds, 1e-9), 2.0, 10.0);
    plan.batch = static_cast<std::int64_t>(std::ceil(static_cast<double>(plan.batch) * factor));
    seconds = seconds_of(work.run, plan.batch);
  }
  plan.run_s = seconds / static_cast<double>(plan.batch);
  plan.warm_up = 1000.0 * plan.run_s < options.slow_ms;
  return plan;
}

}  // namespace impinge::lab

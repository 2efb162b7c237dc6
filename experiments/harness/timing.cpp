// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/timing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

#include <benchmark/benchmark.h>

#include "files/stopwatch.hpp"
#include "harness/timing.hpp"

namespace impinge::lab {
namespace {

constexpr const char* kControlMark = "#control";

// Verifies all cases. Throws std::runtime_error that begins with the case.
void verify_all(const std::vector<TimedCase>& cases, Progress& progress) {
  progress.say("verifying " + std::to_string(cases.size()) + " cases before any is timed");
  for (const TimedCase& work : cases) {
    if (!work.verify) continue;
    try {
      work.verify();
    } catch (const std::exception& wrong) {
      throw std::runtime_error(key_text(work.key) + ": " + wrong.what());
    }
  }
}

// Collects the raw time of every round, under the name of its case.
class SampleReporter : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      samples[run.run_name.function_name].push_back(run.GetAdjustedRealTime());
    }
  }
  std::map<std::string, std::vector<double>> samples;  // milliseconds per run
};

// Runs a round. After an exception, which is kept, the rest of the run does nothing: the harness needs the
// same number of iterations in every round, so they are only counted.
void register_plan(const RoundPlan& plan, const std::string& name, std::exception_ptr& failure,
                   Progress& progress) {
  const auto round = [&plan, &failure, &progress](benchmark::State& state) {
    if (!failure) {
      try {
        if (plan.warm_up) plan.work->run();
        while (state.KeepRunning()) {
          if (plan.work->before) {
            state.PauseTiming();
            plan.work->before();
            state.ResumeTiming();
          }
          plan.work->run();
        }
        progress.advance(plan.round_s(), plan.name);
        return;
      } catch (...) {
        failure = std::current_exception();
      }
    }
    while (state.KeepRunning()) {
    }
  };
  benchmark::RegisterBenchmark(name.c_str(), round)
      ->Iterations(plan.batch)
      ->Repetitions(plan.work->rounds)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

// Sets every option that the environment could change.
void initialise_harness() {
  std::array<std::string, 7> options{"impinge",
                                     "--benchmark_enable_random_interleaving=true",
                                     "--benchmark_min_warmup_time=0",
                                     "--benchmark_out=",
                                     "--benchmark_perf_counters=",
                                     "--benchmark_report_aggregates_only=false",
                                     "--benchmark_display_aggregates_only=false"};
  std::array<char*, options.size() + 1> arguments{};
  for (std::size_t i = 0; i < options.size(); ++i) arguments[i] = options[i].data();
  int count = static_cast<int>(options.size());
  benchmark::Initialize(&count, arguments.data());
}

Timing collect(const RoundPlan& plan, std::vector<double> samples) {
  for (double& sample : samples) sample /= plan.work->units;
  Timing timing;
  timing.key = plan.work->key;
  timing.summary = summarise(samples);
  timing.samples_ms = std::move(samples);
  timing.batch = plan.batch;
  return timing;
}

// The fastest case, if possible of those that repeat within a round.
const RoundPlan& control_of(const std::vector<RoundPlan>& plans) {
  return *std::ranges::min_element(plans, {}, [](const RoundPlan& plan) {
    return std::pair(static_cast<bool>(plan.work->before), plan.round_s());
  });
}

// Runs all rounds of all cases in one random order.
TimingRun run_once(const std::vector<TimedCase>& cases, const TimingOptions& options, Progress& progress) {
  TimingRun result;
  result.options = options;
  std::vector<RoundPlan> plans;
  plans.reserve(cases.size());
  for (const TimedCase& work : cases) plans.push_back(plan_rounds(work, options));
  const RoundPlan& control = control_of(plans);
  double expected = control.round_s() * control.work->rounds;
  for (const RoundPlan& plan : plans) expected += plan.round_s() * plan.work->rounds;

  progress.say("timing " + std::to_string(cases.size()) + " cases, about " + duration_text(expected));
  progress.begin(expected);
  std::exception_ptr failure;
  initialise_harness();
  benchmark::ClearRegisteredBenchmarks();
  for (const RoundPlan& plan : plans) register_plan(plan, plan.name, failure, progress);
  register_plan(control, control.name + kControlMark, failure, progress);
  SampleReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter, nullptr, ".");
  benchmark::ClearRegisteredBenchmarks();
  if (failure) std::rethrow_exception(failure);

  for (const RoundPlan& plan : plans) result.timings.push_back(collect(plan, reporter.samples[plan.name]));
  result.control = collect(control, reporter.samples[control.name + kControlMark]);
  const double first = result.timings[static_cast<std::size_t>(&control - plans.data())].summary.median;
  result.control_ratio = result.control.summary.median / first;
  for (Timing& timing : result.timings)
    timing.inconclusive = is_inconclusive(timing, result.control_ratio, options);
  return result;
}

// Limits the rounds, for tests of everything but the times.
std::vector<TimedCase> with_rounds(std::vector<TimedCase> cases, int most) {
  for (TimedCase& work : cases) work.rounds = std::min(work.rounds, most);
  return cases;
}
TimingOptions without_repeats(TimingOptions options) {
  options.most_repeats = 0;
  return options;
}

}  // namespace

bool is_inconclusive(const Timing& timing, double control_ratio, const TimingOptions& options) {
  return std::abs(control_ratio - 1.0) > options.max_control_off || timing.summary.count < 2 ||
         timing.summary.iqr > options.max_spread * timing.summary.median;
}

void append(TimingRun& all, TimingRun more) {
  if (more.timings.empty()) return;
  const auto off = [](const TimingRun& run) { return std::abs(run.control_ratio - 1.0); };
  if (all.timings.empty() || off(more) > off(all)) {
    all.control = std::move(more.control);
    all.control_ratio = more.control_ratio;
    all.options = more.options;
  }
  std::ranges::move(more.timings, std::back_inserter(all.timings));
}

Timing scaled(Timing timing, double factor) {
  for (double& sample : timing.samples_ms) sample *= factor;
  timing.summary.median *= factor;
  timing.summary.iqr *= factor;
  return timing;
}

const Timing& find(const TimingRun& run, const std::vector<Cell>& key) {
  for (const Timing& timing : run.timings) {
    if (key_text(timing.key) == key_text(key)) return timing;
  }
  throw std::out_of_range(key_text(key) + ": no such timing");
}

TimingRun run_interleaved(const std::vector<TimedCase>& cases, const TimingOptions& options,
                          Progress& progress) {
  if (cases.empty()) return {};
  check_cases(cases);
  verify_all(cases, progress);
  if (const char* most = std::getenv("IMPINGE_ROUNDS"))
    return run_once(with_rounds(cases, std::max(1, std::atoi(most))), without_repeats(options), progress);
  Stopwatch watch;
  TimingRun run = run_once(cases, options, progress);
  const double budget_s = std::max(options.repeat_share * watch.lap_s(), options.least_repeat_s);
  Progress silent("", nullptr);
  const auto alone = [&](const TimedCase& work) { return run_once({work}, options, silent); };
  double spent_s = 0.0;
  repeat_inconclusive(run, cases, {budget_s, alone, [&] { return spent_s += watch.lap_s(); }}, progress);
  return run;
}

}  // namespace impinge::lab

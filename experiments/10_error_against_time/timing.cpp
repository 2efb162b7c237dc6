// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_error_against_time/timing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>
#include <stdexcept>
#include <utility>

#include <benchmark/benchmark.h>

#include "files/stopwatch.hpp"
#include "harness/statistics.hpp"

namespace impinge::lab {
namespace {

constexpr double kNanoseconds = 1e6;    // in a millisecond
constexpr std::size_t kFirstBatch = 8;  // points that tell how long a batch will take

template <class Work>
double milliseconds(Work&& work) {
  Stopwatch watch;
  work();
  return watch.lap_ms();
}

// One method between the rounds.
struct Runner {
  const PointCase* method = nullptr;
  std::optional<PointQuery> kept;
  std::vector<Vec3> batch;
  std::vector<double> out;
  double points = 0.0;  // that one batch answers for
  std::size_t repeats = 1;
  BenchmarkCosts costs;
};

void flush(std::vector<char>& block) {
  for (std::size_t i = 0; i < block.size(); i += 64) ++block[i];
  benchmark::DoNotOptimize(block.data());
  benchmark::ClobberMemory();
}

// As many of the points as one batch has time for, evenly through all of them.
void choose_batch(Runner& runner, const PointQuery& query, const std::vector<Vec3>& all,
                  const BenchmarkTimingOptions& options) {
  runner.points = static_cast<double>(all.size());
  runner.batch = all;
  runner.out.resize(all.size());
  if (runner.method->measure == Measure::pose) return;
  const std::size_t first = std::min(kFirstBatch, all.size());
  const double trial = milliseconds([&] { query.answer(std::span(all).first(first), runner.out); });
  const double affordable = options.batch_ms / trial * static_cast<double>(first);
  if (affordable >= runner.points) return;
  const std::size_t count = std::max(first, static_cast<std::size_t>(affordable));
  for (std::size_t k = 0; k < count; ++k) runner.batch[k] = all[k * all.size() / count];
  runner.batch.resize(count);
  runner.out.resize(count);
  runner.points = static_cast<double>(count);
}

void ask(Runner& runner, const PointQuery& query) {
  query.answer(runner.batch, runner.out);
  benchmark::DoNotOptimize(runner.out.data());
  benchmark::ClobberMemory();
}

void run_round(Runner& runner, const std::vector<Vec3>& all, const BenchmarkTimingOptions& options,
               std::vector<char>& block) {
  std::optional<PointQuery> query = std::exchange(runner.kept, std::nullopt);
  if (!query) runner.costs.build_ms.push_back(milliseconds([&] { query = runner.method->make(); }));
  if (runner.batch.empty()) choose_batch(runner, *query, all, options);
  flush(block);
  runner.costs.cold_ns.push_back(kNanoseconds * milliseconds([&] { ask(runner, *query); }) / runner.points);
  const double once = milliseconds([&] { ask(runner, *query); });
  if (runner.costs.warm_ns.empty())
    runner.repeats = static_cast<std::size_t>(std::ceil(options.warm_ms / std::max(once, 1e-5)));
  const double warm = milliseconds([&] {
    for (std::size_t k = 0; k < runner.repeats; ++k) ask(runner, *query);
  });
  runner.costs.warm_ns.push_back(kNanoseconds * warm / (runner.points * static_cast<double>(runner.repeats)));
  runner.costs.bytes = query->bytes;
  runner.costs.batch = runner.batch.size();
  if (runner.costs.build_ms.front() > options.slow_build_ms) runner.kept = std::move(query);
}

// Samples of every second round.
std::vector<double> half(std::span<const double> samples, std::size_t first) {
  std::vector<double> chosen;
  for (std::size_t k = first; k < samples.size(); k += 2) chosen.push_back(samples[k]);
  return chosen;
}

}  // namespace

std::vector<BenchmarkCosts> time_methods(std::span<const PointCase> methods, const BenchmarkScene& scene,
                                         const BenchmarkTimingOptions& options, Progress& progress) {
  if (options.rounds < 2) throw std::invalid_argument("a control needs two rounds of timing or more");
  const std::vector<Vec3> all = scene.queries();
  std::vector<char> block(options.flush_bytes);
  std::vector<Runner> runners(methods.size());
  for (std::size_t i = 0; i < methods.size(); ++i) runners[i].method = &methods[i];
  std::vector<std::size_t> order(methods.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937_64 random(options.seed);
  progress.begin(options.rounds);
  for (int round = 0; round < options.rounds; ++round) {
    std::ranges::shuffle(order, random);
    for (const std::size_t i : order) run_round(runners[i], all, options, block);
    progress.advance(1.0, scene.name);
  }
  std::vector<BenchmarkCosts> costs;
  costs.reserve(runners.size());
  for (Runner& runner : runners) costs.push_back(std::move(runner.costs));
  return costs;
}

double control_ratio(std::span<const double> samples) {
  return summarise(half(samples, 1)).median / summarise(half(samples, 0)).median;
}

const char* compare_times(std::span<const double> a, std::span<const double> b) {
  const double difference = std::log(summarise(a).median / summarise(b).median);
  const double noise = std::max(std::abs(std::log(control_ratio(a))), std::abs(std::log(control_ratio(b))));
  if (!(std::abs(difference) > noise)) return "inconclusive";
  return difference < 0.0 ? "faster" : "slower";
}

}  // namespace impinge::lab

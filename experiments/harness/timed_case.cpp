// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/timed_case.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <stdexcept>

#include <benchmark/benchmark.h>

#include "files/stopwatch.hpp"

namespace impinge::lab {
namespace {

constexpr std::size_t kCacheLine = 64;  // bytes

double seconds_of(const std::function<void()>& run, std::int64_t times) {
  Stopwatch watch;
  for (std::int64_t i = 0; i < times; ++i) run();
  return watch.lap_s();
}

}  // namespace

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

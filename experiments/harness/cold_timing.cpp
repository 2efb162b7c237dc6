// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/cold_timing.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include <benchmark/benchmark.h>

#include "files/stopwatch.hpp"

namespace impinge::lab {
namespace {

constexpr std::size_t kCacheLine = 64;  // bytes

void overwrite(std::vector<char>& block) {
  for (std::size_t i = 0; i < block.size(); i += kCacheLine) ++block[i];
  benchmark::DoNotOptimize(block.data());
  benchmark::ClobberMemory();
}

double milliseconds_of(const std::function<void()>& run) {
  Stopwatch watch;
  run();
  return watch.lap_ms();
}

}  // namespace

std::vector<Timing> time_cold(const std::vector<ColdCase>& cases, const ColdOptions& options) {
  std::vector<Timing> timings(cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    timings[i].key = cases[i].key;
    cases[i].run();
  }
  std::vector<std::size_t> order(cases.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937_64 random(options.seed);
  std::vector<char> block(options.flush_bytes);
  for (int round = 0; round < options.rounds; ++round) {
    std::ranges::shuffle(order, random);
    for (const std::size_t i : order) {
      overwrite(block);
      timings[i].samples_ms.push_back(milliseconds_of(cases[i].run) / cases[i].units);
    }
  }
  for (Timing& timing : timings) timing.summary = summarise(timing.samples_ms);
  return timings;
}

}  // namespace impinge::lab

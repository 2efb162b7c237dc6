// SPDX-License-Identifier: GPL-3.0-or-later
#include "03_detection_time/detection_timing.hpp"

#include <utility>

#include <benchmark/benchmark.h>

#include "harness/timing_report.hpp"
#include "methods/cgal.hpp"

namespace impinge::lab {
namespace {

constexpr int kFewRounds = 3;

bool is_pairwise(const TouchCase& method) { return method.name == "pairwise"; }

bool is_measured(const BenchmarkJoint& joint, const TouchCase& method, const DetectionOptions& options) {
  return !is_pairwise(method) || joint.pairs <= options.most_pairs;
}

std::vector<Cell> key_of(const BenchmarkJoint& joint, const TouchCase& method) {
  std::vector<Cell> key = joint.before;
  key.emplace_back(method.name);
  key.insert(key.end(), joint.after.begin(), joint.after.end());
  return key;
}

std::vector<TimedCase> benchmark_cases(const std::vector<BenchmarkJoint>& joints,
                                       const DetectionOptions& options) {
  std::vector<TimedCase> cases;
  for (const BenchmarkJoint& joint : joints) {
    for (const auto& method : joint.bench.methods) {
      if (!is_measured(joint, method, options)) continue;
      cases.push_back(benchmark_case(key_of(joint, method), method, joint.bench));
      if (is_pairwise(method) && joint.pairs > options.most_pairs_often) cases.back().rounds = kFewRounds;
    }
  }
  return cases;
}

}  // namespace

DetectionBenchmark make_detection_benchmark(const BallSocketPair& pair, double precision_deg) {
  const auto kept = std::make_shared<const BallSocketPair>(pair);
  return {kept,
          pose_set(pair),
          {{"cgal_tree"}, make_cgal_tree(pair.ball, pair.socket)},
          cases_of(touch_methods(), &Method::touch, *kept, precision_deg)};
}

BenchmarkJoint make_benchmark_joint(std::vector<Cell> before, const BallSocketPair& pair,
                                    std::vector<Cell> after, double precision_deg) {
  const auto pairs =
      static_cast<double>(pair.ball.faces.size()) * static_cast<double>(pair.socket.faces.size());
  return {std::move(before), std::move(after), pairs, make_detection_benchmark(pair, precision_deg)};
}

TimedCase benchmark_case(std::vector<Cell> key, const TouchCase& method, const DetectionBenchmark& bench) {
  TimedCase timed;
  timed.key = std::move(key);
  timed.units = static_cast<double>(bench.poses.size());
  timed.verify = [&method, &bench] { require_agreement(method, bench.oracle, bench.poses); };
  timed.run = [&method, &bench] { benchmark::DoNotOptimize(count_touching(method, bench.poses)); };
  return timed;
}

Timing write_benchmark(DriverRun& driver, Result result, const std::vector<Column>& key_columns,
                       const std::vector<BenchmarkJoint>& joints, const DetectionOptions& options) {
  const TimingRun timed = run_interleaved(benchmark_cases(joints, options), {}, driver.progress);
  Timing pair = options.pair;
  result.table.columns = timing_columns(key_columns);
  result.table.columns.push_back({"gives_distance", "", "yes: the same work yields the gap at every vertex"});
  for (const BenchmarkJoint& joint : joints) {
    add_labels(result.labels, joint.bench.methods);
    for (const auto& method : joint.bench.methods) {
      const std::vector<Cell> key = key_of(joint, method);
      const bool measured = is_measured(joint, method, options);
      if (measured && is_pairwise(method)) pair = scaled(find(timed, key), 1.0 / joint.pairs);
      auto row =
          measured ? timing_cells(find(timed, key)) : extrapolated_cells(key, scaled(pair, joint.pairs));
      row.emplace_back(method.gives_distance);
      result.table.add_row(std::move(row));
    }
  }
  write_timed(driver, std::move(result), key_columns, timed);
  return pair;
}

}  // namespace impinge::lab

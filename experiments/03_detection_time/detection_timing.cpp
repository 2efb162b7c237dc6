// SPDX-License-Identifier: GPL-3.0-or-later
#include "03_detection_time/detection_timing.hpp"

#include <utility>

#include <benchmark/benchmark.h>

#include "harness/timing.hpp"
#include "methods/cgal.hpp"
#include "methods/table_scan.hpp"
#include "sphere/schemes/usid_arc.hpp"

namespace impinge::lab {
namespace {

constexpr int kFewRounds = 3;

bool is_pairwise(const TouchCase& method) { return method.name == "pairwise"; }

bool is_measured(const BenchmarkJoint& joint, const TouchCase& method, const DetectionOptions& options) {
  return !is_pairwise(method) || joint.pairs <= options.most_pairs;
}

std::vector<Cell> key_of(const BenchmarkJoint& joint, const TouchCase& method) {
  std::vector<Cell> key{method.name};
  key.insert(key.end(), joint.key.begin(), joint.key.end());
  return key;
}

std::vector<TimedCase> benchmark_cases(const std::vector<BenchmarkJoint>& joints,
                                       const DetectionOptions& options) {
  std::vector<TimedCase> cases;
  for (const BenchmarkJoint& joint : joints) {
    for (const auto& method : joint.methods) {
      if (!is_measured(joint, method, options)) continue;
      TimedCase timed;
      timed.key = key_of(joint, method);
      timed.units = static_cast<double>(joint.poses.size());
      timed.verify = [&method, &joint] { require_agreement(method, joint.oracle, joint.poses); };
      timed.run = [&method, &joint] { benchmark::DoNotOptimize(count_touching(method, joint.poses)); };
      if (is_pairwise(method) && joint.pairs > options.most_pairs_often) timed.rounds = kFewRounds;
      cases.push_back(std::move(timed));
    }
  }
  return cases;
}

// USID in the other reading of the thesis, with entries at equal arcs.
TouchCase equal_arcs(const BallSocketPair& pair, double precision_deg) {
  const auto scan =
      std::make_shared<TableScan<UsidArc>>(pair.ball, pair.socket, make_tables<UsidArc>(pair, precision_deg));
  return {{std::string(UsidArc::name), "USID, equal arcs", "", 2},
          [scan](const Pose& pose) { return scan->touches(pose); },
          true};
}

}  // namespace

BenchmarkJoint make_benchmark_joint(const BallSocketPair& pair, std::vector<Cell> key, double precision_deg) {
  const auto kept = std::make_shared<const BallSocketPair>(pair);
  auto methods = cases_of(touch_methods(), &Method::touch, *kept, precision_deg);
  methods.push_back(equal_arcs(*kept, precision_deg));
  return {std::move(key),
          static_cast<double>(pair.ball.faces.size()) * static_cast<double>(pair.socket.faces.size()),
          kept,
          pose_set(pair),
          {{"cgal_tree"}, make_cgal_tree(pair.ball, pair.socket)},
          std::move(methods)};
}

void write_benchmark(DriverRun& driver, Result result, const std::vector<Column>& key_columns,
                     const std::vector<BenchmarkJoint>& joints, const DetectionOptions& options) {
  const TimingRun timed = run_interleaved(benchmark_cases(joints, options), {}, driver.progress);
  Timing one_pair;
  result.table.columns = timing_columns(key_columns);
  result.table.columns.push_back({"gives_distance", "", "yes: the same work yields the gap at every vertex"});
  result.table.columns.push_back({"triangles_of_both", "1", "triangles that the two models really have"});
  result.table.columns.push_back({"queries", "1", "vertices of both, which a scan looks up"});
  for (const BenchmarkJoint& joint : joints) {
    add_labels(result.labels, joint.methods);
    for (const auto& method : joint.methods) {
      const std::vector<Cell> key = key_of(joint, method);
      const bool measured = is_measured(joint, method, options);
      if (measured && is_pairwise(method)) one_pair = scaled(find(timed, key), 1.0 / joint.pairs);
      auto row =
          measured ? timing_cells(find(timed, key)) : extrapolated_cells(key, scaled(one_pair, joint.pairs));
      row.emplace_back(method.gives_distance);
      row.emplace_back(joint.pair->ball.faces.size() + joint.pair->socket.faces.size());
      row.emplace_back(joint.pair->ball.vertices.size() + joint.pair->socket.vertices.size());
      result.table.add_row(std::move(row));
    }
  }
  write_timed(driver, std::move(result), key_columns, timed);
}

}  // namespace impinge::lab

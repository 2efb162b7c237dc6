// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/detection_benchmark.hpp"

#include <stdexcept>
#include <string>

#include "methods/cgal_tree.hpp"
#include "methods/fcl_obb.hpp"
#include "methods/pairwise.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/schemes/usid.hpp"

namespace impinge::lab {
namespace {

template <SamplingScheme S>
std::unique_ptr<TouchMethod> make_table_scan(const BallSocketPair& pair, double precision_deg) {
  return std::make_unique<TableScan<S>>(pair.ball, pair.socket, make_tables<S>(pair, precision_deg));
}

}  // namespace

TouchMethod& DetectionBenchmark::method(std::string_view name) const {
  for (const auto& candidate : methods) {
    if (candidate->name() == name) return *candidate;
  }
  throw std::out_of_range(std::string(name) + ": no such method");
}

DetectionBenchmark make_detection_benchmark(const BallSocketPair& pair, double precision_deg) {
  DetectionBenchmark bench;
  bench.poses = pose_set(pair.ball, pair.socket);
  bench.oracle = make_cgal_tree(pair.ball, pair.socket);
  bench.methods.push_back(make_pairwise(pair.ball, pair.socket));
  bench.methods.push_back(make_fcl_obb(pair.ball, pair.socket));
  bench.methods.push_back(make_table_scan<Rsid>(pair, precision_deg));
  bench.methods.push_back(make_table_scan<Usid>(pair, precision_deg));
  return bench;
}

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <stdexcept>

#include <benchmark/benchmark.h>

#include "20_claims/claims_study.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/heap_use.hpp"
#include "methods/table_scan.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/schemes/usid.hpp"

namespace impinge::lab {
namespace {

// Joints of their own shapes: no two share a table.
PairShape shape_of(std::size_t k) {
  PairShape shape = impinging_cam();
  shape.head_radius -= 0.25 * static_cast<double>(k);
  shape.cam_azimuth_deg = 40.0 * static_cast<double>(k);
  return shape;
}

template <SamplingScheme S>
using Scene = std::vector<std::unique_ptr<TableScan<S>>>;

template <SamplingScheme S>
std::unique_ptr<TableScan<S>> make_scan(std::size_t k, const ClaimsOptions& options) {
  const BallSocketPair pair = make_ball_socket_pair(options.faces, shape_of(k));
  return std::make_unique<TableScan<S>>(pair.ball, pair.socket, make_tables<S>(pair, options.precision_deg));
}

template <SamplingScheme S>
void require_same_gaps(Scene<S>& scene, const ClaimsOptions& options) {
  for (std::size_t k = 0; k < scene.size(); ++k) {
    if (scene[k]->smallest_gap({}) == make_scan<S>(k, options)->smallest_gap({})) continue;
    throw std::runtime_error("joint " + std::to_string(k) + " of a scene has another gap than by itself");
  }
}

template <SamplingScheme S>
void add_scheme(ClaimsStudy& study, const ClaimsOptions& options) {
  const char* claim = "several joints in one scene";
  for (const std::size_t count : options.pairs) {
    const std::string setting = std::string(S::name) + ", " + std::to_string(count) + " joints";
    const double before = heap_bytes();
    auto scene = std::make_shared<Scene<S>>();
    for (std::size_t k = 0; k < count; ++k) scene->push_back(make_scan<S>(k, options));
    study.rows.push_back({claim, setting, "memory", heap_bytes() - before, "B"});
    require_same_gaps(*scene, options);
    study.rows.push_back({claim, setting, "identical", 1.0, "1"});
    TimedCase pose;
    pose.key = {claim, setting, "time of a pose of all"};
    pose.rounds = options.rounds;
    pose.run = [scene] {
      for (auto& scan : *scene) benchmark::DoNotOptimize(scan->smallest_gap({}));
    };
    study.cases.push_back(pose);
  }
}

}  // namespace

void add_pairs(ClaimsStudy& study, const ClaimsOptions& options) {
  add_scheme<Rsid>(study, options);
  add_scheme<Usid>(study, options);
}

}  // namespace impinge::lab

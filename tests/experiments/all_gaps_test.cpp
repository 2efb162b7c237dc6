// SPDX-License-Identifier: GPL-3.0-or-later
// All gaps of a pose, on a small pair: every method in both directions, its errors those of exact arithmetic.
#include "10_error_against_time/all_gaps.hpp"

#include <cmath>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "methods/benchmark_scene.hpp"

namespace impinge::lab {
namespace {

TEST(MotionPose, GoesToTheEndAndBeginsAgain) {
  const Pose last = motion_pose(Vec3::UnitX(), 23);
  EXPECT_NEAR(last.rotation(1, 1), std::cos(115.0 * kDegree), 1e-12);
  EXPECT_EQ(motion_pose(Vec3::UnitX(), 24).rotation, motion_pose(Vec3::UnitX(), 0).rotation);
}

TEST(BenchmarkScenes, HipsHaveAboutTheirTriangles) {
  const BenchmarkScene hip = hip_scene("normal", 3000);
  EXPECT_EQ(hip.name, "hip_normal_3000");
  EXPECT_NEAR(static_cast<double>(hip.pair.socket.faces.size()), 3000.0, 90.0);
}

TEST(AllGaps, HaveErrorsAndTimesInBothDirections) {
  BenchmarkOptions options;
  options.radial = {3000, 20, 1};
  options.euclidean = {100, 10, 1};
  options.ascent.starts = 2;
  options.gap_timing.rounds = 1;
  options.gap_timing.slow_build_ms = 0.0;  // every building is slow
  options.gap_timing.flush_bytes = 1 << 16;
  options.gap_timing.options = {.min_round_ms = 0.01, .most_repeats = 0};
  QuestionTable tables = make_gap_table();
  Progress quiet("test", nullptr);
  run_all_gaps(generated_scene(300), {{{32}, {4.0}}}, options, tables, quiet);
  std::map<std::string, std::size_t> column;
  for (const Column& one : tables.table.columns) column.emplace(one.name, column.size());
  std::set<std::string> seen;
  for (const auto& row : tables.table.rows) {
    const auto text = [&](const char* name) { return row.at(column.at(name)).text(); };
    const auto number = [&](const char* name) { return std::stod(text(name)); };
    seen.insert(text("direction") + ' ' + text("method"));
    EXPECT_GT(number("ns_vertex"), 0.0);
    EXPECT_GT(number("build_ms"), 0.0);
    EXPECT_EQ(text("max_over_um").empty(), text("method") == "floor");
    if (text("method") == "floor") continue;
    const double error = std::max(number("max_over_um"), number("max_under_um"));
    EXPECT_LT(error, text("method") == "cube_cells_exact" ? 0.02 : 5000.0);
  }
  for (const char* method : {"cube_cells_exact", "cube_gnomonic_mesh_exact", "rsid", "rsid_scalar",
                             "embree_ray16", "cgal_closest"}) {
    EXPECT_TRUE(seen.contains(std::string("ball->socket ") + method)) << method;
    EXPECT_TRUE(seen.contains(std::string("socket->ball ") + method)) << method;
  }
}

}  // namespace
}  // namespace impinge::lab

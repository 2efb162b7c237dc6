// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How fast are all gaps of a pose found, beside other libraries and beside the machine's limit?
// @writes    fast fast_samples
// @timing    yes
// @seconds   27 165
// @links     harness gaps_methods gap_simd
//
// Kernels with vector instructions, the library's scalar scan, and Embree with 1, 8 and 16 rays at a time, in
// both directions, in one interleaved run. Errors against all triangles come first, and what is too far off
// is not timed. Warm: a method asks for a motion of 24 poses, over and over. Cold: one pose after 96 MiB were
// overwritten. CGAL, VTK and Embree's closest point are asked for few vertices; OpenVDB answers up to 5 mm.
// Closest points and voxels are Euclidean distances.

#include "13_fast/fast_study.hpp"
#include "harness/driver.hpp"
#include "harness/timing_report.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

FastOptions quick_options() {
  FastOptions options;
  options.joints = {{3000, {{kMainCells}, {}, {}, false}},
                    {12000, {{kMainCells, 1100}, {0.5}, {0.5}, true, {0.5}}, true}};
  options.rounds = 5;
  options.ray_tests = 5e7;
  return options;
}

FastOptions full_options() {
  FastOptions options;
  const GapSizes few{{kMainCells}, {0.5}};
  const std::vector<std::size_t> corners{128, kCornersOfAMebibyte, kMainCells, 728};
  options.joints = {
      {300, few},
      {3000, few},
      {12000,
       {{64, 128, kMainCells, 512, 1100}, {1.0, 0.5, 0.25, 0.1}, {0.5, 0.1}, true, {1.0, 0.5, 0.25}, corners},
       true},
      {100000, few},
      {400000, {{kMainCells}, {0.5}, {}, false}}};
  return options;
}

void body(DriverRun& run) {
  FastOptions options = run.quick() ? quick_options() : full_options();
  options.timing.min_round_ms = run.quick() ? 5.0 : 10.0;
  options.seed = run.record.seed;
  FastTables tables = fast_tables(options, run.progress);
  Result result;
  result.name = "fast";
  result.question = "Time of a vertex, error and bytes of every way to find all gaps of a pose?";
  result.parameters = {{"ray_tests_of_the_truth", options.ray_tests}, {"poses", 24}};
  result.table = std::move(tables.table);
  result.labels = tables.labels;
  write_timed(run, std::move(result), fast_keys(), tables.timing);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"13_fast", "All gaps of a pose, beside other libraries and the machine's limit."}, body);
}

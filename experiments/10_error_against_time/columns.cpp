// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_error_against_time/report.hpp"

namespace impinge::lab {
namespace {

const std::vector<Column> kKey{
    {"scene", "", "generated_N: pair of N triangles a model; else the folder of a real joint"},
    {"method", "", "SCHEME: look-up linear in r; SCHEME_mesh_exact: linear in 1/r; others by library"},
    {"setting", "", "spacing and storage of a table, nodes of a grid, mode of a library"}};

std::vector<Column> with_key(const std::vector<Column>& more) {
  std::vector<Column> columns = kKey;
  columns.insert(columns.end(), more.begin(), more.end());
  return columns;
}

}  // namespace

BenchmarkTables make_benchmark_tables() {
  BenchmarkTables tables;
  tables.main.table.columns =
      with_key({{"build_ms", "ms", "median time of everything that is done once for a surface"},
                {"query_ns", "ns", "median time of one vertex, warm"},
                {"bytes", "B", "of everything that is kept; libraries: see the parameters"},
                {"max_over_um", "um", "largest error to the far side: answer minus truth"},
                {"max_under_um", "um", "largest error to the near side: truth minus answer"},
                {"rms_um", "um", "root mean square over directions uniform on the sphere: by solid angle"},
                {"p99_um", "um", "quantile 0.99 of the same errors without sign"},
                {"bound_um", "um", "proven bound on the error; empty where there is none that says anything"},
                {"misses", "1",
                 "directions in which there is a surface and no answer, those along the rim included"}});
  tables.spread.columns = with_key(
      {{"kind", "", "ours, thesis, library, grid or brute"},
       {"scheme", "", "of a table"},
       {"precision_deg", "deg", "spacing of a table's entries at the equator"},
       {"interpolant", "", "smooth, mesh_exact or none"},
       {"storage", "", "double, float, uint16 or none"},
       {"measure", "", "radial; euclidean: distance of a point"},
       {"build_iqr_ms", "ms", "interquartile range over the rounds; empty if built once"},
       {"query_iqr_ns", "ns", "interquartile range over the rounds"},
       {"query_cold_ns", "ns", "median time of one vertex after the cores' own caches were overwritten"},
       {"query_cold_iqr_ns", "ns", "interquartile range of the same"},
       {"directions", "1", "in which the error was looked at"},
       {"false_hits", "1", "directions in which there is an answer and no surface"},
       {"uniform_max_um", "um", "largest error over uniform directions"},
       {"feature_max_um", "um", "over vertices, edges, poles, seam, rim and oblique faces"},
       {"adversarial_max_um", "um", "over the ways up from the worst of them"},
       {"attained_um", "um",
        "largest error that the proof of the bound met; empty where the bound is one of first order"},
       {"tightness", "1", "largest error divided by the bound"},
       {"inconclusive", "", "yes: query_ns says nothing, repeats included"},
       {"repeats", "1", "times that it was timed again, alone, as it was inconclusive"}});
  return tables;
}

std::vector<Column> cost_keys() { return with_key({{"cost", "", "build, query or cold: a cold query"}}); }

BenchmarkOptions quick_benchmark() {
  BenchmarkOptions options;
  options.sizes.tables = {{2.0, 1.0}, 30000, 12000, {1.05, 2000}};
  options.sizes.grid_nodes = {16, 32};
  options.radial = {5000, 200, 1};
  options.euclidean = {300, 50, 1};
  options.ascent.starts = 3;
  options.ascent.steps = 30;
  options.timing = {3, 5.0, 30.0, std::size_t{16} << 20, {}};
  options.timing.options.min_round_ms = 1.0;
  options.gap_timing = {4, 0.0, 100.0, std::size_t{64} << 20, {}};
  options.gap_timing.options.min_round_ms = 4.0;
  options.pose_timing.rounds = 3;
  options.pose_timing.slow_build_ms = 50.0;
  options.pose_timing.options.min_round_ms = 5.0;
  for (BenchmarkTiming* timing : {&options.timing, &options.gap_timing, &options.pose_timing}) {
    timing->options.least_repeat_s = 1.0;
    timing->options.repeat_share = 0.1;
  }
  return options;
}

BenchmarkOptions full_benchmark() {
  BenchmarkOptions options;
  options.sizes.tables = {{2.0, 1.0, 0.5, 0.2}, 110000, 12000, {1.05, 100000}};
  options.sizes.grid_nodes = {16, 32, 64, 128};
  options.radial = {240000, 4000, 1};
  options.euclidean = {20000, 1000, 1};
  options.ascent.starts = 16;
  options.ascent.steps = 60;
  options.timing.options.min_round_ms = 5.0;
  options.gap_timing.rounds = 15;
  options.gap_timing.options.min_round_ms = 10.0;
  options.pose_timing.rounds = 11;
  options.pose_timing.options.min_round_ms = 5.0;
  return options;
}

}  // namespace impinge::lab

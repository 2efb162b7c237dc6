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
  tables.main.columns = with_key(
      {{"build_ms", "ms", "median time of everything that is done once for a surface"},
       {"query_ns", "ns", "median time of one vertex, warm; of a pose divided by the ball's vertices"},
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
       {"measure", "", "radial; euclidean: distance of a point; pose: one smallest distance"},
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
       {"aa_ratio", "1", "A/A control: median query time of the odd rounds over that of the even ones"},
       {"aa_verdict", "",
        "against embree_ray1 fast (the reference): faster, slower, or inconclusive where one of the two "
        "differs from itself by as much"}});
  tables.samples.columns = with_key({{"cost", "", "build_ms, query_ns or query_cold_ns"},
                                     {"round", "1", "in the order of measurement"},
                                     {"value", "ms or ns", "wall clock, in the unit of the cost"}});
  return tables;
}

BenchmarkOptions quick_benchmark() {
  BenchmarkOptions options;
  options.sizes.tables = {{2.0, 1.0}, 30000, 12000, {1.05, 2000}};
  options.sizes.grid_nodes = {16, 32};
  options.radial = {5000, 200, 1};
  options.euclidean = {300, 50, 1};
  options.ascent.starts = 3;
  options.ascent.steps = 30;
  options.timing.rounds = 4;
  options.timing.warm_ms = 0.5;
  options.timing.batch_ms = 5.0;
  options.timing.slow_build_ms = 30.0;
  options.timing.flush_bytes = 16U << 20U;
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
  return options;
}

}  // namespace impinge::lab

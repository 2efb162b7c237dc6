// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_error_against_time/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include <benchmark/benchmark.h>

#include "files/stopwatch.hpp"

namespace impinge::lab {
namespace {

constexpr std::size_t kFirstBatch = 8;  // points that are timed to estimate a batch

// Points, and the answers to them.
struct Batch {
  std::vector<Vec3> points;
  std::vector<double> out;
};

// A method with everything that was measured of it.
struct Measured {
  PointCase method;
  std::shared_ptr<const PointQuery> query;
  double build_s = 0.0;  // of the query, at first use
  BenchmarkErrors errors;
  MethodBound bound;
  double truth_apart = 0.0;  // see BenchmarkProbes, mm
};

// Times of a method, in the order in which costs_of() asks for them.
struct Costs {
  const Timing& build;
  const Timing& warm;
  const Timing& cold;
};

struct Truth {
  BenchmarkProbes radial;
  BenchmarkProbes euclidean;

  const BenchmarkProbes& of(Measure measure) const { return measure == Measure::radial ? radial : euclidean; }
};

void examine(Measured& measured, const BenchmarkScene& scene, const Truth& truth,
             const BenchmarkOptions& options) {
  Stopwatch watch;
  measured.query = std::make_shared<const PointQuery>(measured.method.make());
  measured.build_s = watch.lap_s();
  const BenchmarkProbes& probes = truth.of(measured.method.measure);
  measured.errors = measure_errors(*measured.query, probes, options.ascent);
  measured.truth_apart = probes.truth_apart;
  if (measured.method.bound) measured.bound = measured.method.bound(*measured.query);
  require_bound(measured.errors, measured.bound, {scene.name, measured.method.name, measured.method.setting});
}

// The points of one batch of batch_ms, evenly spread through the list.
std::vector<Vec3> batch_of(const PointQuery& query, const std::vector<Vec3>& all, double batch_ms) {
  std::vector<double> out(all.size());
  const std::size_t first = std::min(kFirstBatch, all.size());
  Stopwatch watch;
  query.answer(std::span(all).first(first), out);
  const double affordable = batch_ms / watch.lap_ms() * static_cast<double>(first);
  if (affordable >= static_cast<double>(all.size())) return all;
  std::vector<Vec3> some(std::max(first, static_cast<std::size_t>(affordable)));
  for (std::size_t k = 0; k < some.size(); ++k) some[k] = all[k * all.size() / some.size()];
  return some;
}

std::vector<Cell> key_of(const Measured& measured, const BenchmarkScene& scene) {
  return {scene.name, measured.method.name, measured.method.setting};
}

// What is common to the costs of a scene's methods.
struct Costing {
  const BenchmarkScene& scene;
  const BenchmarkTiming& timing;
  std::vector<Vec3> queries;
  std::function<void()> flush;
  Built<PointQuery> built;
};

// Building; asking warm; asking cold.
std::array<TimedCase, 3> costs_of(const Measured& measured, const Costing& costing) {
  const auto key = [&](const char* cost) {
    std::vector<Cell> cells = key_of(measured, costing.scene);
    cells.emplace_back(cost);
    return cells;
  };
  TimedCase warm;
  warm.key = key("query");
  warm.rounds = costing.timing.rounds;
  const auto& all = costing.queries;
  auto batch = std::make_shared<Batch>();
  batch->points = batch_of(*measured.query, all, costing.timing.batch_ms);
  batch->out.resize(batch->points.size());
  warm.units = static_cast<double>(batch->points.size());
  warm.run = [query = measured.query, batch] {
    query->answer(batch->points, batch->out);
    benchmark::DoNotOptimize(batch->out.data());
    benchmark::ClobberMemory();
  };
  TimedCase cold = warm;
  cold.key = key("cold");
  cold.before = costing.flush;
  return {build_case(key("build"), costing.built, measured.method.make, measured.build_s, costing.timing),
          warm, cold};
}

TimingRun time_all(const std::vector<Measured>& all, const BenchmarkScene& scene,
                   const BenchmarkTiming& timing, Progress& progress) {
  const Costing costing{scene, timing, scene.queries(), overwrite_caches(timing.flush_bytes),
                        std::make_shared<std::optional<PointQuery>>()};
  std::vector<TimedCase> cases;
  for (const Measured& measured : all)
    std::ranges::move(costs_of(measured, costing), std::back_inserter(cases));
  return run_interleaved(cases, timing.options, progress);
}

// Micrometres; empty for an infinite bound.
Cell bound_cell(double bound_mm) { return std::isfinite(bound_mm) ? Cell(kMicrometres * bound_mm) : Cell(); }

// A cell that is empty where the value has no meaning for the method.
Cell cell_if(bool there, double value) { return there ? Cell(value) : Cell(); }

void add_main(Table& table, const Measured& measured, const BenchmarkScene& scene, const Costs& costs) {
  const BenchmarkErrors& errors = measured.errors;
  std::vector<Cell> row = key_of(measured, scene);
  row.insert(row.end(),
             {costs.build.summary.median, kNanoseconds * costs.warm.summary.median, measured.query->bytes,
              kMicrometres * errors.max_over, kMicrometres * errors.max_under, kMicrometres * errors.rms,
              kMicrometres * errors.p99, bound_cell(measured.bound.bound_mm), errors.misses});
  table.add_row(std::move(row));
}

void add_spread(Table& table, const Measured& measured, const BenchmarkScene& scene, const Costs& costs) {
  const PointCase& method = measured.method;
  const BenchmarkErrors& errors = measured.errors;
  std::vector<Cell> row = key_of(measured, scene);
  row.insert(row.end(), {method.kind,
                         method.scheme,
                         method.precision_deg,
                         method.interpolant,
                         method.storage,
                         name_of(method.measure),
                         cell_if(costs.build.summary.count > 1, costs.build.summary.iqr),
                         kNanoseconds * costs.warm.summary.iqr,
                         kNanoseconds * costs.cold.summary.median,
                         kNanoseconds * costs.cold.summary.iqr,
                         errors.directions,
                         errors.false_hits,
                         kMicrometres * errors.uniform_max,
                         kMicrometres * errors.feature_max,
                         kMicrometres * errors.adversarial_max,
                         kMicrometres * measured.bound.attained_mm,
                         errors.max() / measured.bound.bound_mm,
                         costs.warm.inconclusive,
                         costs.warm.repeats,
                         kMicrometres * measured.truth_apart});
  table.add_row(std::move(row));
}

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

void run_benchmark(const BenchmarkScene& scene, const BenchmarkOptions& options, BenchmarkTables& tables,
                   Progress& progress) {
  const Truth truth{radial_probes(scene, options.radial), euclidean_probes(scene, options.euclidean)};
  const std::vector<PointCase> methods = cases_of(points_methods(), &Method::points, scene, options.sizes);
  add_labels(tables.main.labels, methods);
  progress.say(scene.name + ": errors of " + std::to_string(methods.size()) + " methods");
  std::vector<Measured> all;
  progress.begin(static_cast<double>(methods.size()));
  for (const PointCase& method : methods) {
    all.push_back({method, {}, 0.0, {}, {}, 0.0});
    examine(all.back(), scene, truth, options);
    progress.advance(1.0, method.name + " " + method.setting);
  }
  TimingRun timing = time_all(all, scene, options.timing, progress);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Costs costs{timing.timings[3 * i], timing.timings[3 * i + 1], timing.timings[3 * i + 2]};
    add_main(tables.main.table, all[i], scene, costs);
    add_spread(tables.spread, all[i], scene, costs);
  }
  append(tables.main.timing, std::move(timing));
}

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
       {"repeats", "1", "times that it was timed again, alone, as it was inconclusive"},
       {"truths_apart_um", "um",
        "largest difference of the truth in double, which the ways up climb by, from CGAL's exact one"}});
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

QuestionTable question_table(std::vector<Column> keys, const std::vector<Column>& values) {
  keys.insert(keys.end(), values.begin(), values.end());
  return {{std::move(keys), {}}};
}

}  // namespace impinge::lab

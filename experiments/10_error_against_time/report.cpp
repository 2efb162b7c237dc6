// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_error_against_time/report.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "harness/statistics.hpp"
#include "methods/surface_distance.hpp"

namespace impinge::lab {
namespace {

constexpr double kMicrometres = 1000.0;           // in a millimetre
constexpr const char* kBaseline = "embree_ray1";  // that times are compared with
constexpr const char* kBaselineSetting = "fast";

// A method with everything that was found out about it.
struct Measured {
  PointCase method;
  BenchmarkErrors errors;
  MethodBound bound;
  BenchmarkCosts costs;

  bool is_pose() const { return method.measure == Measure::pose; }
};

struct Truth {
  BenchmarkProbes radial;
  BenchmarkProbes euclidean;
  double pose = 0.0;
};

BenchmarkErrors errors_of(const PointQuery& query, Measure measure, const Truth& truth,
                          const AscentOptions& ascent) {
  switch (measure) {
    case Measure::radial:
      return measure_errors(query, truth.radial, ascent);
    case Measure::euclidean:
      return measure_errors(query, truth.euclidean, ascent);
    case Measure::pose:
      return measure_pose(query, truth.pose);
  }
  return {};
}

void examine(Measured& measured, const BenchmarkScene& scene, const Truth& truth,
             const BenchmarkOptions& options) {
  const PointQuery query = measured.method.make();
  measured.errors = errors_of(query, measured.method.measure, truth, options.ascent);
  if (measured.method.bound) measured.bound = measured.method.bound(query);
  auto violation = find_violation(measured.errors, measured.bound);
  if (!violation) return;
  violation->scene = scene.name;
  violation->method = measured.method.name;
  violation->setting = measured.method.setting;
  throw BoundViolated(*violation);
}

std::vector<Cell> key_of(const Measured& measured, const BenchmarkScene& scene) {
  return {scene.name, measured.method.name, measured.method.setting};
}

// Micrometres; an infinite bound promises nothing.
Cell bound_cell(double bound_mm) { return std::isfinite(bound_mm) ? Cell(kMicrometres * bound_mm) : Cell(); }

// A cell that is empty where the value has no meaning for the method.
Cell cell_if(bool there, double value) { return there ? Cell(value) : Cell(); }

void add_main(Table& table, const Measured& measured, const BenchmarkScene& scene) {
  const BenchmarkErrors& errors = measured.errors;
  const bool answered = measured.method.says_how_far;
  std::vector<Cell> row = key_of(measured, scene);
  row.insert(row.end(), {summarise(measured.costs.build_ms).median, summarise(measured.costs.warm_ns).median,
                         measured.costs.bytes, cell_if(answered, kMicrometres * errors.max_over),
                         cell_if(answered, kMicrometres * errors.max_under),
                         cell_if(!measured.is_pose(), kMicrometres * errors.rms),
                         cell_if(!measured.is_pose(), kMicrometres * errors.p99),
                         bound_cell(measured.bound.bound_mm), errors.misses});
  table.add_row(std::move(row));
}

void add_spread(Table& table, const Measured& measured, const BenchmarkScene& scene,
                const BenchmarkCosts& baseline) {
  const PointCase& method = measured.method;
  const BenchmarkErrors& errors = measured.errors;
  const Summary cold = summarise(measured.costs.cold_ns);
  const bool many = !measured.is_pose();
  std::vector<Cell> row = key_of(measured, scene);
  row.insert(
      row.end(),
      {method.kind, method.scheme, method.precision_deg, method.interpolant, method.storage,
       name_of(method.measure),
       cell_if(measured.costs.build_ms.size() > 1, summarise(measured.costs.build_ms).iqr),
       summarise(measured.costs.warm_ns).iqr, cold.median, cold.iqr, errors.directions, errors.false_hits,
       cell_if(many, kMicrometres * errors.uniform_max), cell_if(many, kMicrometres * errors.feature_max),
       cell_if(many, kMicrometres * errors.adversarial_max), kMicrometres * measured.bound.attained_mm,
       errors.max() / measured.bound.bound_mm, control_ratio(measured.costs.warm_ns)});
  const bool reference = method.name == kBaseline && method.setting == kBaselineSetting;
  row.emplace_back(reference ? "reference" : compare_times(measured.costs.warm_ns, baseline.warm_ns));
  table.add_row(std::move(row));
}

void add_samples(Table& table, const Measured& measured, const BenchmarkScene& scene) {
  const auto add = [&](const char* cost, const std::vector<double>& samples) {
    for (std::size_t k = 0; k < samples.size(); ++k) {
      std::vector<Cell> row = key_of(measured, scene);
      row.insert(row.end(), {cost, k + 1, samples[k]});
      table.add_row(std::move(row));
    }
  };
  add("build_ms", measured.costs.build_ms);
  add("query_ns", measured.costs.warm_ns);
  add("query_cold_ns", measured.costs.cold_ns);
}

const BenchmarkCosts& baseline_of(const std::vector<Measured>& all) {
  for (const Measured& measured : all) {
    if (measured.method.name == kBaseline && measured.method.setting == kBaselineSetting)
      return measured.costs;
  }
  throw std::logic_error("the benchmark lacks the method that times are compared with");
}

}  // namespace

BoundViolated::BoundViolated(const Violation& violation)
    : std::runtime_error("a proven bound does not hold, so the proof or the program is wrong: " +
                         violation.text()),
      violation_(violation) {}

void run_benchmark(const BenchmarkScene& scene, const BenchmarkOptions& options, BenchmarkTables& tables,
                   Progress& progress) {
  const Truth truth{radial_probes(scene, options.radial), euclidean_probes(scene, options.euclidean),
                    surface_distance(scene)};
  const std::vector<PointCase> methods = cases_of(points_methods(), &Method::points, scene, options.sizes);
  add_labels(tables.labels, methods);
  progress.say(scene.name + ": errors of " + std::to_string(methods.size()) + " methods");
  std::vector<Measured> all;
  progress.begin(static_cast<double>(methods.size()));
  for (const PointCase& method : methods) {
    all.push_back({method, {}, {}, {}});
    examine(all.back(), scene, truth, options);
    progress.advance(1.0, method.name + " " + method.setting);
  }
  progress.say(scene.name + ": times");
  std::vector<BenchmarkCosts> costs = time_methods(methods, scene, options.timing, progress);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].costs = std::move(costs[i]);
  const BenchmarkCosts& baseline = baseline_of(all);
  for (const Measured& measured : all) {
    add_main(tables.main, measured, scene);
    add_spread(tables.spread, measured, scene, baseline);
    add_samples(tables.samples, measured, scene);
  }
}

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_error_against_time/race_report.hpp"

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
struct Raced {
  MethodMaker maker;
  RaceErrors errors;
  MethodBound bound;
  RaceCosts costs;

  bool is_pose() const { return maker.measure == Measure::pose; }
};

struct Truth {
  RaceProbes radial;
  RaceProbes euclidean;
  double pose = 0.0;
};

RaceErrors errors_of(RadiusMethod& method, Measure measure, const Truth& truth, const AscentOptions& ascent) {
  switch (measure) {
    case Measure::radial:
      return measure_errors(method, truth.radial, ascent);
    case Measure::euclidean:
      return measure_errors(method, truth.euclidean, ascent);
    case Measure::pose:
      return measure_pose(method, truth.pose);
  }
  return {};
}

void examine(Raced& raced, const RaceScene& scene, const Truth& truth, const RaceOptions& options) {
  const auto method = raced.maker.make();
  raced.errors = errors_of(*method, raced.maker.measure, truth, options.ascent);
  if (raced.maker.bound) raced.bound = raced.maker.bound(*method);
  auto violation = find_violation(raced.errors, raced.bound);
  if (!violation) return;
  violation->scene = scene.name;
  violation->method = raced.maker.name;
  violation->setting = raced.maker.setting;
  throw BoundViolated(*violation);
}

std::vector<Cell> key_of(const Raced& raced, const RaceScene& scene) {
  return {scene.name, raced.maker.name, raced.maker.setting};
}

// Micrometres; an infinite bound promises nothing.
Cell bound_cell(double bound_mm) { return std::isfinite(bound_mm) ? Cell(kMicrometres * bound_mm) : Cell(); }

// A cell that is empty where the value has no meaning for the method.
Cell cell_if(bool there, double value) { return there ? Cell(value) : Cell(); }

void add_main(Table& table, const Raced& raced, const RaceScene& scene) {
  const RaceErrors& errors = raced.errors;
  const bool answered = !raced.is_pose() || raced.maker.name != "fcl_collide";
  std::vector<Cell> row = key_of(raced, scene);
  row.insert(row.end(), {summarise(raced.costs.build_ms).median, summarise(raced.costs.warm_ns).median,
                         raced.costs.bytes, cell_if(answered, kMicrometres * errors.max_over),
                         cell_if(answered, kMicrometres * errors.max_under),
                         cell_if(!raced.is_pose(), kMicrometres * errors.rms),
                         cell_if(!raced.is_pose(), kMicrometres * errors.p99),
                         bound_cell(raced.bound.bound_mm), errors.misses});
  table.add_row(std::move(row));
}

void add_spread(Table& table, const Raced& raced, const RaceScene& scene, const RaceCosts& baseline) {
  const MethodMaker& maker = raced.maker;
  const RaceErrors& errors = raced.errors;
  const Summary cold = summarise(raced.costs.cold_ns);
  const bool many = !raced.is_pose();
  std::vector<Cell> row = key_of(raced, scene);
  row.insert(
      row.end(),
      {maker.kind, maker.scheme, maker.precision_deg, maker.interpolant, maker.storage,
       name_of(maker.measure), cell_if(raced.costs.build_ms.size() > 1, summarise(raced.costs.build_ms).iqr),
       summarise(raced.costs.warm_ns).iqr, cold.median, cold.iqr, errors.directions, errors.false_hits,
       cell_if(many, kMicrometres * errors.uniform_max), cell_if(many, kMicrometres * errors.feature_max),
       cell_if(many, kMicrometres * errors.adversarial_max), kMicrometres * raced.bound.attained_mm,
       errors.max() / raced.bound.bound_mm, control_ratio(raced.costs.warm_ns)});
  const bool reference = maker.name == kBaseline && maker.setting == kBaselineSetting;
  row.emplace_back(reference ? "reference" : compare_times(raced.costs.warm_ns, baseline.warm_ns));
  table.add_row(std::move(row));
}

void add_samples(Table& table, const Raced& raced, const RaceScene& scene) {
  const auto add = [&](const char* cost, const std::vector<double>& samples) {
    for (std::size_t k = 0; k < samples.size(); ++k) {
      std::vector<Cell> row = key_of(raced, scene);
      row.insert(row.end(), {cost, k + 1, samples[k]});
      table.add_row(std::move(row));
    }
  };
  add("build_ms", raced.costs.build_ms);
  add("query_ns", raced.costs.warm_ns);
  add("query_cold_ns", raced.costs.cold_ns);
}

std::vector<MethodMaker> all_methods(const RaceScene& scene, const RaceOptions& options) {
  std::vector<MethodMaker> all = other_methods(scene, options.grid_nodes);
  for (auto&& more : {thesis_methods(scene, options.tables), table_methods(scene, options.tables)})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

const RaceCosts& baseline_of(const std::vector<Raced>& all) {
  for (const Raced& raced : all) {
    if (raced.maker.name == kBaseline && raced.maker.setting == kBaselineSetting) return raced.costs;
  }
  throw std::logic_error("the race lacks the method that times are compared with");
}

}  // namespace

BoundViolated::BoundViolated(const Violation& violation)
    : std::runtime_error("a proven bound does not hold, so the proof or the program is wrong: " +
                         violation.text()),
      violation_(violation) {}

void run_race(const RaceScene& scene, const RaceOptions& options, RaceTables& tables, Progress& progress) {
  const Truth truth{radial_probes(scene, options.radial), euclidean_probes(scene, options.euclidean),
                    surface_distance(scene)};
  const std::vector<MethodMaker> makers = all_methods(scene, options);
  progress.say(scene.name + ": errors of " + std::to_string(makers.size()) + " methods");
  std::vector<Raced> all;
  progress.begin(static_cast<double>(makers.size()));
  for (const MethodMaker& maker : makers) {
    all.push_back({maker, {}, {}, {}});
    examine(all.back(), scene, truth, options);
    progress.advance(1.0, maker.name + " " + maker.setting);
  }
  progress.say(scene.name + ": times");
  std::vector<RaceCosts> costs = time_methods(makers, scene, options.timing, progress);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].costs = std::move(costs[i]);
  const RaceCosts& baseline = baseline_of(all);
  for (const Raced& raced : all) {
    add_main(tables.main, raced, scene);
    add_spread(tables.spread, raced, scene, baseline);
    add_samples(tables.samples, raced, scene);
  }
}

}  // namespace impinge::lab

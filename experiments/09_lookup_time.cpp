// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How long does one look-up take with each scheme?
// @writes    lookup_time lookup_time_samples
// @timing    yes
// @seconds   10 40
// @links     harness reference
//
// Tables of about as many entries as RSID has at 1 degree, half a megabyte, looked up at points in random
// directions: no look-up profits from the one before it, as neighbouring vertices of a mesh would. The points
// are as far from the centre as vertices of a hip are, so that a scheme that needs unit vectors makes them.

#include <cmath>
#include <memory>
#include <random>
#include <stdexcept>

#include <benchmark/benchmark.h>

#include "harness/driver.hpp"
#include "harness/timing_report.hpp"
#include "reference/scheme_search.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/scheme_list.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/uniform_directions.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::size_t kLookups = 20000;  // in one run
constexpr std::size_t kChecked = 2000;   // of them, compared with what is known before anything is timed
constexpr double kNearest = 20.0;        // mm
constexpr double kFarthest = 30.0;       // mm
const Vec3 kSlope(0.3, -0.5, 0.8);       // mm, of a body whose radius is kMean + kSlope . u
constexpr double kMean = 25.0;           // mm

std::vector<Vec3> points(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < kLookups; ++i) {
    const Vec3 u = uniform_direction(random);
    points.push_back((kNearest + (kFarthest - kNearest) * uniform(random)) * u);
  }
  return points;
}

double true_radius(const Vec3& u) { return kMean + kSlope.dot(u); }

// No tap is farther from the direction than the stencil radius, so the mean of their radii is not off by more
// than the radius changes on that way.
template <SamplingScheme S>
void verify(const RadialTable<S>& table, const std::vector<Vec3>& points) {
  const double bound = kSlope.norm() * table.scheme().stencil_radius() + 1e-12 * kMean;
  for (std::size_t i = 0; i < kChecked; ++i) {
    const double off = std::abs(table.radius_at(points[i]) - true_radius(points[i].normalized()));
    if (!(off <= bound)) {
      throw std::runtime_error("a look-up is off by " + std::to_string(off) + " mm, more than " +
                               std::to_string(bound));
    }
  }
}

struct AddCase {
  DriverRun& run;
  const std::vector<Vec3>& points;
  std::vector<TimedCase>& cases;

  template <SamplingScheme S>
  void operator()() const {
    const S scheme = scheme_of_size<S>(Rsid::with_precision(1.0).size());
    const auto table = std::make_shared<RadialTable<S>>(scheme);
    for (std::size_t i = 0; i < scheme.size(); ++i) table->radii()[i] = true_radius(scheme.direction(i));
    TimedCase timed;
    timed.key = {S::name, scheme.size()};
    timed.units = static_cast<double>(kLookups);
    timed.rounds = run.quick() ? 15 : 45;
    timed.run = [table, &look_up = points] {
      double sum = 0.0;
      for (const Vec3& x : look_up) sum += table->radius_at(x);
      benchmark::DoNotOptimize(sum);
    };
    timed.verify = [table, &look_up = points] { verify(*table, look_up); };
    cases.push_back(std::move(timed));
  }
};

void body(DriverRun& run) {
  const std::vector<Vec3> look_up = points(run.record.seed);
  std::vector<TimedCase> cases;
  for_each_scheme(AddCase{run, look_up, cases});
  const TimingRun timed = run_interleaved(cases, {}, run.progress);
  const std::vector<Column> keys{{"scheme", "", "name of the sampling scheme"},
                                 {"entries", "1", "of the table"}};
  Result result;
  result.name = "lookup_time";
  result.question = "How long does one look-up take with each scheme?";
  result.table = medians_in_ns(keys, timed, "look-up");
  result.parameters = {
      {"lookups", kLookups}, {"directions", "random"}, {"distances_mm", {kNearest, kFarthest}}};
  write_timed(run, result, keys, timed);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(argc, argv, {"09_lookup_time", "Time of one look-up with every scheme."},
                                  body);
}

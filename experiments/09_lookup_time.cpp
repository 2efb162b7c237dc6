// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How long does a look-up take with each scheme, and does it slow down as tables grow?
// @writes    lookup_time lookup_time_samples stencil_time stencil_time_samples
// @timing    yes
// @seconds   15 65
// @links     harness scheme_metrics
//
// Tables have about as many entries as RSID has at 1 degree, half a megabyte. They are looked up at points in
// random directions, so no look-up profits from the one before it, as with neighbouring vertices of a mesh.
// The points are as far from the centre as vertices of a hip, so a scheme that needs unit vectors has to make
// them. The thesis says that polyhedra need a search, O(n log n) for n look-ups (Section 4.5). To test this
// only the stencil is computed and no radius is read, since the memory of a larger table is slower anyway.

#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <stdexcept>

#include <benchmark/benchmark.h>

#include "harness/driver.hpp"
#include "harness/timing.hpp"
#include "scheme_metrics/scheme_search.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/scheme_list.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/uniform_directions.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::size_t kLookups = 20000;  // in one run
constexpr std::size_t kChecked = 2000;   // of these, verified
constexpr std::array<std::size_t, 2> kStencilEntries{1000,
                                                     1000000};  // a search would take twice as many steps
constexpr double kNearest = 20.0;                               // mm
constexpr double kFarthest = 30.0;                              // mm
const Vec3 kSlope(0.3, -0.5, 0.8);  // mm, of a body whose radius is kMean + kSlope . u
constexpr double kMean = 25.0;      // mm

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

// No tap is farther from the direction than the stencil radius. The mean of the taps' radii is therefore off
// by no more than the radius changes over that angle.
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

// Every tap must be an entry within the stencil radius.
template <SamplingScheme S>
void verify(const S& scheme, const std::vector<Vec3>& points) {
  for (const Vec3& x : points) {
    const Stencil stencil = scheme.stencil(x.normalized());
    for (std::size_t k = 0; k < stencil.taps; ++k) {
      if (stencil.weight[k] > 0.0 &&
          angle_between(scheme.direction(stencil.entry[k]), x) > scheme.stencil_radius() + 1e-9) {
        throw std::runtime_error("a tap is farther away than the stencil radius");
      }
    }
  }
}

// The cases of both questions; `points` must outlive them.
struct Cases {
  bool quick;
  const std::vector<Vec3>& points;
  std::vector<Vec3> directions;
  std::vector<TimedCase> lookups;
  std::vector<TimedCase> stencils;

  template <SamplingScheme S>
  void operator()() {
    const S scheme = scheme_of_size<S>(Rsid::with_precision(1.0).size());
    const auto table = std::make_shared<RadialTable<S>>(scheme);
    for (std::size_t i = 0; i < scheme.size(); ++i) table->radii()[i] = true_radius(scheme.direction(i));
    add<S>(lookups, {quick ? 9 : 45, scheme.size()}, table, points,
           [](const auto& of, const Vec3& x) { return of.radius_at(x); });
    for (const std::size_t entries : kStencilEntries) {
      const auto of_size = std::make_shared<S>(scheme_of_size<S>(entries));
      add<S>(stencils, {quick ? 7 : 31, of_size->size()}, of_size, directions,
             [](const S& of, const Vec3& u) { return of.stencil(u); });
    }
  }

 private:
  struct Size {
    int rounds;
    std::size_t entries;
  };

  template <SamplingScheme S, class Asked, class Answer>
  static void add(std::vector<TimedCase>& cases, Size size, const std::shared_ptr<Asked>& asked,
                  const std::vector<Vec3>& where, Answer answer) {
    TimedCase timed;
    timed.key = {S::name, size.entries};
    timed.units = static_cast<double>(kLookups);
    timed.rounds = size.rounds;
    timed.run = [asked, &where, answer] {
      for (const Vec3& x : where) benchmark::DoNotOptimize(answer(*asked, x));
    };
    timed.verify = [asked, &where] { verify(*asked, where); };
    cases.push_back(std::move(timed));
  }
};

void time_and_write(DriverRun& run, const std::vector<TimedCase>& cases, Result result,
                    const std::string& unit) {
  const TimingRun timed = run_interleaved(cases, {}, run.progress);
  const std::vector<Column> keys{{"scheme", "", "name of the sampling scheme"},
                                 {"entries", "1", "of the table or the scheme"}};
  result.table = medians_in_ns(keys, timed, unit);
  write_timed(run, std::move(result), keys, timed);
}

void body(DriverRun& run) {
  const std::vector<Vec3> look_up = points(run.record.seed);
  Cases cases{run.quick(), look_up, {}, {}, {}};
  for (const Vec3& x : look_up) cases.directions.push_back(x.normalized());
  for_each_scheme(cases);
  Result lookup{"lookup_time", "How long does one look-up take with each scheme?"};
  lookup.parameters = {
      {"lookups", kLookups}, {"directions", "random"}, {"distances_mm", {kNearest, kFarthest}}};
  time_and_write(run, cases.lookups, std::move(lookup), "look-up");
  Result stencil{"stencil_time",
                 "Does finding the entries of a look-up take longer the more of them there are?"};
  stencil.parameters = {{"stencils", kLookups}, {"directions", "random"}};
  time_and_write(run, cases.stencils, std::move(stencil), "stencil");
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"09_lookup_time", "Time of one look-up with every scheme, and of finding its entries."},
      body);
}

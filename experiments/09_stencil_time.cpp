// SPDX-License-Identifier: GPL-3.0-or-later
// @question  Does finding the entries of a look-up take longer the more of them there are? (Section 4.5)
// @writes    stencil_time stencil_time_samples
// @timing    yes
// @seconds   10 25
// @links     harness reference
//
// The thesis says that polyhedra need a search, O(n log n) for n look-ups. Only the stencil is computed here,
// no radius is read: the memory of a larger table is slower, whatever the scheme.

#include <array>
#include <memory>
#include <random>
#include <stdexcept>

#include <benchmark/benchmark.h>

#include "harness/driver.hpp"
#include "harness/timing_report.hpp"
#include "reference/scheme_search.hpp"
#include "sphere/scheme_list.hpp"
#include "sphere/uniform_directions.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::array<std::size_t, 2> kEntries{1000, 1000000};  // a search would take twice as many steps
constexpr std::size_t kStencils = 20000;                       // in one run

std::vector<Vec3> directions(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Vec3> directions;
  for (std::size_t i = 0; i < kStencils; ++i) directions.push_back(uniform_direction(random));
  return directions;
}

// Every tap must be an entry within the stencil radius.
template <SamplingScheme S>
void verify(const S& scheme, const std::vector<Vec3>& directions) {
  for (const Vec3& u : directions) {
    const Stencil stencil = scheme.stencil(u);
    for (std::size_t k = 0; k < stencil.taps; ++k) {
      if (stencil.weight[k] > 0.0 &&
          angle_between(scheme.direction(stencil.entry[k]), u) > scheme.stencil_radius() + 1e-9) {
        throw std::runtime_error(std::string(S::name) + ": a tap is farther away than the stencil radius");
      }
    }
  }
}

struct AddCases {
  DriverRun& run;
  const std::vector<Vec3>& directions;
  std::vector<TimedCase>& cases;

  template <SamplingScheme S>
  void operator()() const {
    for (const std::size_t entries : kEntries) {
      const auto scheme = std::make_shared<S>(scheme_of_size<S>(entries));
      TimedCase timed;
      timed.key = {S::name, scheme->size()};
      timed.units = static_cast<double>(kStencils);
      timed.rounds = run.quick() ? 9 : 31;
      timed.run = [scheme, &look_up = directions] {
        for (const Vec3& u : look_up) benchmark::DoNotOptimize(scheme->stencil(u));
      };
      timed.verify = [scheme, &look_up = directions] { verify(*scheme, look_up); };
      cases.push_back(std::move(timed));
    }
  }
};

void body(DriverRun& run) {
  const std::vector<Vec3> look_up = directions(run.record.seed);
  std::vector<TimedCase> cases;
  for_each_scheme(AddCases{run, look_up, cases});
  const TimingRun timed = run_interleaved(cases, {}, run.progress);
  const std::vector<Column> keys{{"scheme", "", "name of the sampling scheme"},
                                 {"entries", "1", "of the scheme"}};
  Result result;
  result.name = "stencil_time";
  result.question = "Does finding the entries of a look-up take longer the more of them there are?";
  result.table = medians_in_ns(keys, timed, "stencil");
  result.parameters = {{"stencils", kStencils}, {"directions", "random"}};
  write_timed(run, result, keys, timed);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"09_stencil_time", "Time to find the entries of a look-up, by their number."}, body);
}

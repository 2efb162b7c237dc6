// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How long does filling the two tables of a joint take? (Table 3)
// @writes    sampling_time sampling_time_samples
// @timing    yes
// @seconds   100 560
//
// The generated pair of 3,000 triangles a model. One run makes and fills the table of the ball and that of
// the socket.

#include <array>
#include <functional>

#include <benchmark/benchmark.h>

#include "contenders/table_check.hpp"
#include "experiment/driver.hpp"
#include "experiment/timing_report.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "sampling/exact_raster.hpp"
#include "sampling/thesis_raster.hpp"
#include "sphere/schemes/rsid.hpp"

namespace {

using namespace impinge;
using Fill = std::function<RadialTable<Rsid>(const TriangleMesh&, const Rsid&, Layer)>;

constexpr std::array kPrecisions{1.0, 0.5, 0.1, 0.05};  // degrees
constexpr std::size_t kTriangles = 3000;                // of each model
constexpr double kTestSeconds = 2e-9;                   // a ray against a triangle, for the time left alone
constexpr double kFinestInQuick = 0.5;           // finest precision that the quick profile fills pairwise
constexpr double kExactTolerance = 1e-9 * 30.0;  // mm: 1e-9 of the largest radius

TimedCase make_case(std::string_view method, const Fill& fill, const BallSocketPair& pair, double precision) {
  const Rsid scheme = Rsid::with_precision(precision);
  TimedCase timed;
  timed.key = {method, precision, kTriangles};
  timed.rounds = precision < 0.1 ? 5 : 15;
  timed.run = [fill, &pair, scheme] {
    for (const auto& [mesh, layer] :
         {std::pair{&pair.ball, Layer::farthest}, {&pair.socket, Layer::nearest}}) {
      const RadialTable<Rsid> table = fill(*mesh, scheme, layer);
      benchmark::DoNotOptimize(table.radii().data());
    }
  };
  timed.verify = [fill, &pair, scheme, exact = method == "rsid"] {
    for (const auto& [mesh, layer] :
         {std::pair{&pair.ball, Layer::farthest}, {&pair.socket, Layer::nearest}}) {
      const double tolerance = exact ? kExactTolerance : thesis_raster_bound(*mesh);
      require_radii(fill(*mesh, scheme, layer), *mesh, layer, {2000, tolerance, exact});
    }
  };
  return timed;
}

// The baseline needs no check: it is what the others are checked against. Fine tables get few rounds.
TimedCase pairwise_case(const BallSocketPair& pair, double precision) {
  TimedCase timed = make_case("pairwise", fill_pairwise<Rsid>, pair, precision);
  const auto tests = static_cast<double>(2 * kTriangles * Rsid::with_precision(precision).size());
  timed.verify = nullptr;
  timed.rounds = precision < 0.1 ? 1 : precision < 0.5 ? 2 : 5;
  if (precision < 0.5) timed.expected_s = kTestSeconds * tests;
  return timed;
}

std::vector<TimedCase> make_cases(const BallSocketPair& pair, double finest_pairwise) {
  std::vector<TimedCase> cases;
  for (const double precision : kPrecisions) {
    if (precision >= finest_pairwise) cases.push_back(pairwise_case(pair, precision));
    cases.push_back(make_case("rsid_thesis", fill_thesis, pair, precision));
    cases.push_back(make_case("rsid", fill_exact<Rsid>, pair, precision));
  }
  return cases;
}

// The work of the baseline is one test a triangle and entry, so its time scales with the entries.
void extrapolate(Table& table, const TimingRun& timed) {
  const auto measured = static_cast<double>(Rsid::with_precision(kFinestInQuick).size());
  const double median = find(timed, {"pairwise", kFinestInQuick, kTriangles}).summary.median;
  for (const double precision : kPrecisions) {
    if (precision >= kFinestInQuick) continue;
    const auto entries = static_cast<double>(Rsid::with_precision(precision).size());
    table.add_row(extrapolated_cells({"pairwise", precision, kTriangles}, median * entries / measured));
  }
}

void body(DriverRun& run) {
  const BallSocketPair pair = make_ball_socket_pair(kTriangles);
  const TimingRun timed =
      run_interleaved(make_cases(pair, run.quick() ? kFinestInQuick : 0.0), {}, run.progress);
  const std::vector<Column> keys{
      {"method", "", "way of filling: pairwise, rsid_thesis (linear in the angles) or rsid (exact raster)"},
      {"precision_deg", "deg", "spacing of the entries at the equator"},
      {"triangles", "1", "triangles of each model"}};
  Result result;
  result.name = "sampling_time";
  result.question = "How long does filling the two tables of a joint take?";
  result.table.columns = timing_columns(keys);
  result.parameters = {{"pair", "generated, default shape"},
                       {"counted", "making, filling and freeing the tables of ball and socket, in double"},
                       {"extrapolation", "pairwise finer than 0.5 degrees in the quick profile, by entries"}};
  for (const Timing& timing : timed.timings) result.table.add_row(timing_cells(timing));
  if (run.quick()) extrapolate(result.table, timed);
  write_timed(run, result, keys, timed);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::run_driver(argc, argv,
                             {"02_sampling_time", "Time to fill the tables of a joint (Table 3)."}, body);
}

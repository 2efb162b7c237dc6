// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How long does filling the two tables of a joint take? (Tables 3 and 8)
// @writes    sampling_time sampling_time_samples
// @timing    yes
// @seconds   105 550
// @links     experiment contenders
//
// The generated pair of 3,000 triangles a model. One run makes and fills the table of the ball and that of
// the socket.

#include <array>

#include <benchmark/benchmark.h>

#include "contenders/fill_method.hpp"
#include "experiment/driver.hpp"
#include "experiment/timing_report.hpp"

namespace {

using namespace impinge;

constexpr std::array kPrecisions{1.0, 0.5, 0.1, 0.05};  // degrees
constexpr std::size_t kTriangles = 3000;                // of each model
constexpr std::size_t kChecked = 2000;                  // entries of a table, before it is timed
constexpr double kTestSeconds = 2e-9;                   // a ray against a triangle, for the time left alone
constexpr double kScaledFrom = 0.5;  // finest precision of a pairwise filling that scales to others

template <SamplingScheme S>
TimedCase make_case(const FillMethod<S>& method, const BallSocketPair& pair, double precision) {
  const S scheme = S::with_precision(precision);
  TimedCase timed;
  timed.key = {method.name, precision, kTriangles};
  timed.rounds = precision < 0.1 ? 5 : precision < 0.5 ? 9 : 15;
  timed.verify = [=, &pair] { require_filling(method, pair, scheme, kChecked); };
  timed.run = [=, &pair] {
    for_both_tables(method, pair, scheme,
                    [](const auto& table, const TriangleMesh& /*mesh*/, Layer /*layer*/) {
                      benchmark::DoNotOptimize(table.radii().data());
                    });
  };
  return timed;
}

// Every ray against every face. Fine tables take long and get few rounds.
template <SamplingScheme S>
TimedCase pairwise_case(const FillMethod<S>& method, const BallSocketPair& pair, double precision) {
  TimedCase timed = make_case(method, pair, precision);
  const auto tests = static_cast<double>(2 * kTriangles * S::with_precision(precision).size());
  timed.rounds = precision < 0.1 ? 1 : precision < 0.5 ? 2 : 3;
  if (precision < 0.5) timed.expected_s = kTestSeconds * tests;
  return timed;
}

std::vector<TimedCase> make_cases(const BallSocketPair& pair, double finest_pairwise) {
  std::vector<TimedCase> cases;
  for (const double precision : kPrecisions) {
    if (precision >= finest_pairwise) cases.push_back(pairwise_case(kPairwise, pair, precision));
    cases.push_back(make_case(kRsidThesis, pair, precision));
    cases.push_back(make_case(kRsid, pair, precision));
    if (precision >= kScaledFrom) cases.push_back(pairwise_case(kUsidPairwise, pair, precision));
    cases.push_back(make_case(kUsidThesis, pair, precision));
    cases.push_back(make_case(kUsid, pair, precision));
  }
  return cases;
}

// The work of a pairwise filling is one test a triangle and entry, so its time scales with the entries.
template <SamplingScheme S>
void extrapolate(Table& table, const TimingRun& timed, const FillMethod<S>& method) {
  const auto measured = static_cast<double>(S::with_precision(kScaledFrom).size());
  const double median = find(timed, {method.name, kScaledFrom, kTriangles}).summary.median;
  for (const double precision : kPrecisions) {
    if (precision >= kScaledFrom) continue;
    const auto entries = static_cast<double>(S::with_precision(precision).size());
    table.add_row(extrapolated_cells({method.name, precision, kTriangles}, median * entries / measured));
  }
}

void body(DriverRun& run) {
  const BallSocketPair pair = make_ball_socket_pair(kTriangles);
  const TimingRun timed =
      run_interleaved(make_cases(pair, run.quick() ? kScaledFrom : 0.0), {}, run.progress);
  const std::vector<Column> keys{{"method", "",
                                  "pairwise, usid_pairwise: every ray against every face; rsid_thesis, "
                                  "usid_thesis: in short time, as the thesis; rsid, usid: exact raster"},
                                 {"precision_deg", "deg", "spacing of the entries at the equator"},
                                 {"triangles", "1", "triangles of each model"}};
  Result result;
  result.name = "sampling_time";
  result.question = "How long does filling the two tables of a joint take?";
  result.table.columns = timing_columns(keys);
  result.parameters = {
      {"pair", "generated, default shape"},
      {"counted", "making, filling and freeing the tables of ball and socket, in double"},
      {"extrapolation",
       "finer than 0.5 degrees, by entries: usid_pairwise, and in the quick profile pairwise"}};
  for (const Timing& timing : timed.timings) result.table.add_row(timing_cells(timing));
  if (run.quick()) extrapolate(result.table, timed, kPairwise);
  extrapolate(result.table, timed, kUsidPairwise);
  write_timed(run, result, keys, timed);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::run_driver(
      argc, argv, {"02_sampling_time", "Time to fill the tables of a joint (Tables 3 and 8)."}, body);
}

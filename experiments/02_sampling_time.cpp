// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How long does filling the two tables of a joint take? (Tables 3 and 8)
// @writes    sampling_time sampling_time_samples
// @timing    yes
// @seconds   114 330
// @links     harness methods
//
// On the generated pair of 3,000 triangles per model, one run fills the tables of ball and socket. Making,
// emptying, masking and freeing the tables is part of the time. Methods that end in _kept are timed as in the
// thesis: their tables are made once, and only drawing into them is timed.
//
// A pairwise filling tests each triangle against each entry. Where that would take too long, only a part of
// the entries, spread evenly over the table, is timed; the time is scaled by their number.

#include <array>
#include <memory>

#include <benchmark/benchmark.h>

#include "harness/driver.hpp"
#include "harness/timing.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/fill_method.hpp"
#include "sphere/schemes/usid_arc.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::array kPrecisions{1.0, 0.5, 0.1, 0.05};  // degrees
constexpr std::size_t kTriangles = 3000;                // of each model
constexpr std::size_t kChecked = 2000;  // entries of a table that are checked before it is timed
constexpr double kCheckedAt = 6.0;      // degrees, precision at which a slow filling is checked
constexpr double kTestSeconds = 1e-9;   // a ray against a prepared triangle, to estimate the time left
constexpr double kLong = 5e9;      // tests: a longer filling is not run just to find out how long it takes
constexpr int kRoundsOfAPart = 7;  // rounds of a part of a pairwise filling

// Most tests of a ray against a triangle for which a pairwise filling is timed whole, and the number of tests
// in a round for which a larger one is timed.
struct PairwiseSize {
  double most_whole;
  double in_a_part;
};

int rounds_at(double precision) { return precision < 0.1 ? 3 : precision < 0.5 ? 9 : 15; }
// A round takes seconds if tables are filled from a grid.
int rounds_by_grid(double precision) { return precision < 0.5 ? 3 : 9; }

std::vector<Cell> key_of(std::string_view method, double precision) {
  return {method, precision, kTriangles};
}

template <SamplingScheme S>
TimedCase make_case(const FillMethod<S>& method, const BallSocketPair& pair, double precision) {
  const S scheme = S::with_precision(precision);
  TimedCase timed;
  timed.key = key_of(method.name, precision);
  timed.rounds = rounds_at(precision);
  timed.verify = [=, &pair] { require_filling(method, pair, scheme, kChecked); };
  timed.run = [=, &pair] {
    for_both_tables(method, pair, scheme,
                    [](const auto& table, const TriangleMesh& /*mesh*/, Layer /*layer*/) {
                      benchmark::DoNotOptimize(table.radii().data());
                    });
  };
  return timed;
}

// USID in the other reading of the thesis, with entries at equal arcs. Finding fine ones takes minutes.
constexpr FillMethod<UsidArc> kUsidArcThesis{"usid_arc_thesis", fill_resampled<UsidArc>, resampling_bound};
constexpr double kFinestArcs = 0.5;  // degrees, finest precision with equal arcs

// Both fillings of existing tables; the first filling makes the tables.
void add_kept(std::vector<TimedCase>& cases, const BallSocketPair& pair, double precision) {
  const auto kept = std::make_shared<KeptTables>(pair, precision);
  TimedCase grids;
  grids.key = key_of("rsid_thesis_kept", precision);
  grids.rounds = rounds_at(precision);
  grids.verify = [=, &pair] { require_kept(*kept, pair, kChecked); };
  grids.run = [=] {
    kept->fill_grids();
    benchmark::DoNotOptimize(kept->socket_grid().radii().data());
  };
  TimedCase helices = grids;
  helices.key = key_of("usid_thesis_kept", precision);
  helices.rounds = rounds_by_grid(precision);
  helices.verify = nullptr;  // already verified by the other
  helices.run = [=] {
    kept->fill_helices();
    benchmark::DoNotOptimize(kept->socket_helix().radii().data());
  };
  cases.push_back(grids);
  cases.push_back(helices);
}

// Rays against every triangle of both models; cast(u, layer) exists for the ball and for the socket. Fewer
// than one unit means a part of the entries.
template <SamplingScheme S, class CastBall, class CastSocket>
TimedCase rays_case(std::string_view name, double precision, const PairwiseSize& size, const CastBall& ball,
                    const CastSocket& socket) {
  const S scheme = S::with_precision(precision);
  const auto tests = static_cast<double>(2 * kTriangles * scheme.size());
  const bool whole = tests <= size.most_whole;
  const std::size_t count =
      whole ? scheme.size() : static_cast<std::size_t>(size.in_a_part / static_cast<double>(2 * kTriangles));
  TimedCase timed;
  timed.key = key_of(name, precision);
  timed.units = static_cast<double>(count) / static_cast<double>(scheme.size());
  timed.rounds = whole ? 3 : kRoundsOfAPart;
  if (whole && tests > kLong) timed.expected_s = kTestSeconds * tests;
  timed.run = [=] {
    const double step = static_cast<double>(scheme.size()) / static_cast<double>(count);
    for (std::size_t k = 0; k < count; ++k) {
      const Vec3 u = scheme.direction(static_cast<std::size_t>(static_cast<double>(k) * step));
      benchmark::DoNotOptimize(ball(u) + socket(u));
    }
  };
  return timed;
}

template <SamplingScheme S>
TimedCase pairwise_case(std::string_view name, const BallSocketPair& pair, double precision,
                        const PairwiseSize& size) {
  const auto ball = std::make_shared<RayCaster>(pair.ball);
  const auto socket = std::make_shared<RayCaster>(pair.socket);
  return rays_case<S>(
      name, precision, size, [=](const Vec3& u) { return ball->cast(u, Layer::farthest); },
      [=](const Vec3& u) { return socket->cast(u, Layer::nearest); });
}

TimedCase thesis_pairwise_case(const BallSocketPair& pair, double precision, const PairwiseSize& size) {
  TimedCase timed = rays_case<Rsid>(
      kPairwiseThesis.name, precision, size,
      [&pair](const Vec3& u) { return thesis_ray_radius(pair.ball, u, Layer::farthest); },
      [&pair](const Vec3& u) { return thesis_ray_radius(pair.socket, u, Layer::nearest); });
  timed.verify = [&pair] {
    require_filling(kPairwiseThesis, pair, Rsid::with_precision(kCheckedAt), kChecked);
  };
  return timed;
}

std::vector<TimedCase> make_cases(const BallSocketPair& pair, bool quick) {
  const PairwiseSize prepared{quick ? 1e9 : 4e10, 1e8};  // a nanosecond per test: 1 degree whole, or 0.1
  const PairwiseSize plain{quick ? 0.0 : 4e8, 1e7};      // eleven nanoseconds: none whole, or 1 degree
  std::vector<TimedCase> cases;
  for (const double precision : kPrecisions) {
    cases.push_back(pairwise_case<Rsid>("pairwise", pair, precision, prepared));
    cases.push_back(thesis_pairwise_case(pair, precision, plain));
    cases.push_back(make_case(kRsidThesis, pair, precision));
    cases.push_back(make_case(kRsid, pair, precision));
    cases.push_back(pairwise_case<Usid>("usid_pairwise", pair, precision, {2e9, prepared.in_a_part}));
    cases.push_back(make_case(kUsidThesis, pair, precision));
    cases.back().rounds = rounds_by_grid(precision);
    cases.push_back(make_case(kUsid, pair, precision));
    if (precision >= kFinestArcs) cases.push_back(make_case(kUsidArcThesis, pair, precision));
    add_kept(cases, pair, precision);
  }
  return cases;
}

void body(DriverRun& run) {
  const BallSocketPair pair = make_ball_socket_pair(kTriangles);
  const std::vector<TimedCase> cases = make_cases(pair, run.quick());
  const TimingRun timed = run_interleaved(cases, {}, run.progress);
  const std::vector<Column> keys{
      {"method", "",
       "pairwise, usid_pairwise: every ray against every face, prepared once a face; pairwise_thesis: the "
       "plain test of each pair; rsid_thesis, usid_thesis: in short time, as the thesis; usid_arc_thesis: "
       "with "
       "entries at equal arcs; the same with "
       "_kept: "
       "into tables that are kept; rsid, usid: exact raster"},
      {"precision_deg", "deg", "spacing of the entries at the equator"},
      {"triangles", "1", "triangles of each model"}};
  Result result{
      "sampling_time", "How long does filling the two tables of a joint take?", {timing_columns(keys)}};
  result.parameters = {
      {"pair", "generated, default shape"},
      {"triangles_of_both", pair.ball.faces.size() + pair.socket.faces.size()},
      {"counted", "making, filling, masking and freeing the tables of ball and socket, in double"},
      {"counted_kept", "drawing into tables that are there: not made, emptied, masked or freed"},
      {"counted_pairwise", "the rays alone"},
      {"extrapolation",
       "pairwise fillings that take too long: a part of the entries is timed, evenly spread"}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Timing& timing = timed.timings[i];
    result.table.add_row(cases[i].units < 1.0 ? extrapolated_cells(timing.key, timing)
                                              : timing_cells(timing));
  }
  write_timed(run, result, keys, timed);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"02_sampling_time", "Time to fill the tables of a joint (Tables 3 and 8)."}, body);
}

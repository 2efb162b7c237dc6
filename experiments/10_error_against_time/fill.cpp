// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_error_against_time/fill.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

#include <benchmark/benchmark.h>

#include "harness/timing_report.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/fill.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

// What the cases of a joint and a precision share.
struct FillStage {
  std::shared_ptr<const BallSocketPair> pair;
  CubeGnomonic scheme;
  std::shared_ptr<const FloatDirections> directions;
};

using Fillings = std::array<TableFilling, 2>;  // of ball and socket

Fillings fillings_of(const FillCase& method, const FillStage& stage) {
  return {method.make({stage.pair->ball, Layer::farthest, stage.scheme, stage.directions}, method.threads),
          method.make({stage.pair->socket, Layer::nearest, stage.scheme, stage.directions}, method.threads)};
}

// Lets the C library keep blocks that are freed for the next to ask, or hand back all large ones at once.
void keep_memory(bool kept) {
#ifdef M_MMAP_THRESHOLD
  constexpr int kFew = 1 << 17;
  constexpr int kMost = 1 << 25;
  mallopt(M_MMAP_THRESHOLD, kept ? kMost : kFew);
  mallopt(M_TRIM_THRESHOLD, kept ? 8 * kMost : kFew);
#endif
}

// Entries with a surface must have its radius, within the tolerance of the way.
void require_right(const TableFilling& filling, const RadialTable<CubeGnomonic>& exact,
                   const FillCase& method) {
  std::size_t off = 0;
  for (std::size_t e = 0; e < exact.radii().size(); ++e) {
    const double expected = exact.radii()[e];
    if (!std::isnan(expected) && !(std::abs(filling.radius(e) - expected) <= filling.tolerance())) ++off;
  }
  if (static_cast<double>(off) > method.most_off * static_cast<double>(exact.radii().size())) {
    throw std::runtime_error(method.name + " " + method.storage + " has " + std::to_string(off) +
                             " entries that are off: its time means nothing until they are right");
  }
}

TimedCase fill_case(const FillStage& stage, const FillCase& method, bool again, int rounds) {
  auto both = std::make_shared<Fillings>(fillings_of(method, stage));
  TimedCase timed;
  timed.key = {method.name,
               method.storage,
               again ? "used again" : "fresh",
               method.threads,
               stage.pair->ball.faces.size(),
               stage.scheme.divisions(),
               2 * stage.scheme.size()};
  timed.rounds = rounds;
  timed.run = [both, again, pair = stage.pair] {
    keep_memory(again);
    for (const auto& filling : *both) {
      filling.fill();
      benchmark::ClobberMemory();
      if (!again) filling.forget();
    }
  };
  return timed;
}

void check(const FillStage& stage, const std::vector<FillCase>& methods) {
  const auto ball = fill_exact(stage.pair->ball, stage.scheme, Layer::farthest);
  const auto socket = fill_exact(stage.pair->socket, stage.scheme, Layer::nearest);
  for (const FillCase& method : methods) {
    const Fillings both = fillings_of(method, stage);
    for (const auto& filling : both) filling.fill();
    require_right(both[0], ball, method);
    require_right(both[1], socket, method);
  }
}

}  // namespace

std::vector<Column> fill_keys() {
  return {{"method", "",
           "cube_at_once: drawn and stored at once; cube_in_double: the rasteriser of all schemes; "
           "embree_fill: a tree and coherent rays, 16 in a packet, along the same directions"},
          {"storage", "", "of an entry: uint16, float or double"},
          {"memory", "", "fresh: from the system in each run; used again: kept from the last run"},
          {"threads", "1", "that fill; Embree's tree is built by one"},
          {"triangles", "1", "of each of the two models"},
          {"cells", "1", "along an edge of the cube"},
          {"entries", "1", "of both tables"}};
}

QuestionTable fill_tables(const FillPlan& plan, const BenchmarkTiming& timing, Progress& progress) {
  const std::vector<FillCase> methods = cases_of(fill_methods(), &Method::fill);
  std::vector<std::shared_ptr<const BallSocketPair>> pairs;
  for (const std::size_t triangles : plan.triangles)
    pairs.push_back(std::make_shared<const BallSocketPair>(make_ball_socket_pair(triangles)));
  std::vector<TimedCase> cases;
  for (const std::size_t cells : plan.cells) {
    const auto scheme = CubeGnomonic::with_precision(90.0 / static_cast<double>(cells));
    const auto directions = std::make_shared<const FloatDirections>(scheme);
    for (const auto& pair : pairs) {
      const FillStage stage{pair, scheme, directions};
      check(stage, methods);
      for (const FillCase& method : methods) {
        cases.push_back(fill_case(stage, method, false, timing.rounds));
        cases.push_back(fill_case(stage, method, true, timing.rounds));
      }
    }
  }
  QuestionTable found{{timing_columns(fill_keys()), {}}};
  add_labels(found.labels, methods);
  found.timing = run_interleaved(cases, timing.options, progress);
  for (const Timing& one : found.timing.timings) found.table.add_row(timing_cells(one));
  return found;
}

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "13_fill/fill_study.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

#include <benchmark/benchmark.h>

#include "13_fill/fill_methods.hpp"
#include "mesh/generated_pair.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

// What the cases of a joint and a precision share.
struct FillStage {
  std::shared_ptr<const BallSocketPair> pair;
  CubeGnomonic scheme;
  std::shared_ptr<const RayDirections> directions;
};

using Fillings = std::array<std::unique_ptr<TableFilling>, 2>;  // of ball and socket

Fillings fillings_of(const FillingMaker& maker, const FillStage& stage) {
  return {maker.make({stage.pair->ball, Layer::farthest, stage.scheme, stage.directions}, maker.threads),
          maker.make({stage.pair->socket, Layer::nearest, stage.scheme, stage.directions}, maker.threads)};
}

std::shared_ptr<const RayDirections> directions_of(const CubeGnomonic& scheme) {
  std::vector<Vec3> directions;
  directions.reserve(scheme.size());
  for (std::size_t e = 0; e < scheme.size(); ++e) directions.push_back(scheme.direction(e));
  return std::make_shared<const RayDirections>(directions);
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
                   const FillingMaker& maker) {
  std::size_t off = 0;
  for (std::size_t e = 0; e < exact.radii().size(); ++e) {
    const double expected = exact.radii()[e];
    if (!std::isnan(expected) && !(std::abs(filling.radius(e) - expected) <= filling.tolerance())) ++off;
  }
  if (static_cast<double>(off) > maker.most_off * static_cast<double>(exact.radii().size())) {
    throw std::runtime_error(maker.name + " " + maker.storage + " has " + std::to_string(off) +
                             " entries that are off: its time means nothing until they are right");
  }
}

TimedCase fill_case(const FillStage& stage, const FillingMaker& maker, bool again, int rounds) {
  auto both = std::make_shared<Fillings>(fillings_of(maker, stage));
  TimedCase timed;
  timed.key = {maker.name,
               maker.storage,
               again ? "used again" : "fresh",
               maker.threads,
               stage.pair->ball.faces.size(),
               stage.scheme.divisions(),
               2 * stage.scheme.size()};
  timed.rounds = rounds;
  timed.run = [both, again, pair = stage.pair] {
    keep_memory(again);
    for (const auto& filling : *both) {
      filling->fill();
      benchmark::ClobberMemory();
      if (!again) filling->forget();
    }
  };
  return timed;
}

void check(const FillStage& stage) {
  const auto ball = fill_exact(stage.pair->ball, stage.scheme, Layer::farthest);
  const auto socket = fill_exact(stage.pair->socket, stage.scheme, Layer::nearest);
  for (const FillingMaker& maker : filling_methods()) {
    const Fillings both = fillings_of(maker, stage);
    for (const auto& filling : both) filling->fill();
    require_right(*both[0], ball, maker);
    require_right(*both[1], socket, maker);
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

TimingRun time_filling(const FillOptions& options, Progress& progress) {
  std::vector<std::shared_ptr<const BallSocketPair>> pairs;
  for (const std::size_t triangles : options.triangles)
    pairs.push_back(std::make_shared<const BallSocketPair>(make_ball_socket_pair(triangles)));
  std::vector<TimedCase> cases;
  for (const std::size_t cells : options.cells) {
    const auto scheme = CubeGnomonic::with_precision(90.0 / static_cast<double>(cells));
    const auto directions = directions_of(scheme);
    for (const auto& pair : pairs) {
      const FillStage stage{pair, scheme, directions};
      check(stage);
      for (const FillingMaker& maker : filling_methods()) {
        cases.push_back(fill_case(stage, maker, false, options.rounds));
        cases.push_back(fill_case(stage, maker, true, options.rounds));
      }
    }
  }
  return run_interleaved(cases, options.timing, progress);
}

}  // namespace impinge::lab

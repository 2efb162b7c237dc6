// SPDX-License-Identifier: GPL-3.0-or-later
// Two ridges meet, at ever smaller angles to one another.
#include <array>

#include "stress/known_turn.hpp"

namespace impinge::lab {
namespace {

constexpr std::array kAtParallelEdges{45.0, 5.0, 1e-1, 1e-3, 1e-6, 1e-9, 1e-12, 0.0};  // degrees

std::vector<StabilityCase> run_parallel_edges(const StabilityRun& run) {
  return over_turns(kAtParallelEdges, run,
                    [](std::size_t k, double degrees) { return meeting_ridges(k, degrees * kDegree); });
}

}  // namespace

StabilityFamily parallel_edges_family() {
  return {"parallel_edges",
          "angle between two edges that meet",
          "deg",
          "The angle of contact keeps all its digits, which do not depend on the place of contact that grows "
          "uncertain.",
          kTurnThreshold,
          kTurnDerivation,
          {0.0, 0.0},
          kTurnMutation,
          run_parallel_edges};
}

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// A ridge that just grazes another as it passes.
#include <array>

#include "stress/known_turn.hpp"

namespace impinge::lab {
namespace {

constexpr std::array kAtGrazingTurn{1e-1, 1e-2, 1e-4, 1e-6, 1e-9, 1e-12};  // mm

std::vector<StabilityCase> run_grazing_turn(const StabilityRun& run) {
  return over_turns(kAtGrazingTurn, run, grazing_ridges);
}

}  // namespace

StabilityFamily grazing_turn_family() {
  return {"grazing_turn",
          "depth by which two ridges overlap where they pass each other",
          "mm",
          "The first contact is found whatever the depth, between two steps and between two vertices; below "
          "1e-12 of the radius it may be told to be unknown.",
          kTurnThreshold,
          kTurnDerivation,
          {1.4, 0.0},
          kTurnMutation,
          run_grazing_turn};
}

}  // namespace impinge::lab

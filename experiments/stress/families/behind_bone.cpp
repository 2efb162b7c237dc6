// SPDX-License-Identifier: GPL-3.0-or-later
// Bone passes behind bone, on the side away from the centre: radii overlap, but nothing touches.
#include <array>

#include "stress/known_turn.hpp"

namespace impinge::lab {
namespace {

constexpr std::array kAtBehindBone{1.0, 1e-2, 1e-4, 1e-6, 1e-9, 1e-12};  // mm

std::vector<StabilityCase> run_behind_bone(const StabilityRun& run) {
  return over_turns(kAtBehindBone, run, passing_behind);
}

}  // namespace

StabilityFamily behind_bone_family() {
  return {"behind_bone",
          "distance at which bone passes behind bone",
          "mm",
          "The turn is free, to the last digits of the distance: from 1e-12 of the radius on it may be told "
          "to be unknown.",
          kTurnThreshold,
          kTurnDerivation,
          {0.0, 0.0},
          kTurnMutation,
          run_behind_bone};
}

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// A contact comes ever nearer to the border of an open mesh.
#include <array>

#include "stress/known_turn.hpp"
#include "stress/measure.hpp"

namespace impinge::lab {
namespace {

constexpr std::array kAtBesideOpening{1.0, 1e-2, 1e-4, 1e-6, 1e-9, 1e-12};  // mm

// The sheet that the tip meets, seen along a row of directions as near to its border.
StabilityScene beside_border(double beside_mm) {
  StabilityScene scene;
  scene.mesh = tip_beside_opening(0, beside_mm).bones.socket;
  for (double z = -6.0; z < 6.0; z += 0.37) scene.directions.emplace_back(20.0, 15.0, z);
  return scene;
}

std::vector<StabilityCase> run_beside_opening(const StabilityRun& run) {
  std::vector<StabilityCase> rows = over_turns(kAtBesideOpening, run, tip_beside_opening);
  const auto scenes_at = [](double beside_mm) { return std::vector{beside_border(beside_mm)}; };
  const std::vector<StabilityCase> more = sweep(kAtBesideOpening, scenes_at, run);
  rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

}  // namespace

StabilityFamily beside_opening_family() {
  return {"beside_opening",
          "distance of a contact from the border of a mesh",
          "mm",
          "The contact is found up to the border, or told to be unknown where the tip is through the opening "
          "within 1e-9 mm; a table answers nothing in a cell that the border crosses.",
          kRadiusThreshold,
          kRadiusDerivation,
          {1.2, 0.28},
          kTurnMutation,
          run_beside_opening};
}

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// Tables so coarse that a cell is a large part of the sphere, and steps that do not divide a circle.
#include <array>

#include "mesh/bodies.hpp"
#include "sphere/uniform_directions.hpp"
#include "stress/measure.hpp"
#include "stress/shapes.hpp"

namespace impinge::lab {
namespace {

constexpr std::array kDegreesApart{7.0, 11.0, 25.0, 30.0, 45.0, 70.0, 90.0, 180.0};

std::vector<StabilityCase> run_huge_step(const StabilityRun& run) {
  const auto scenes_at = [&](double degrees) {
    StabilityScene scene;
    scene.mesh = sphere(22.0, 300, {4.0, 3.0, -2.0});
    scene.directions = uniform_directions(run.quick ? 500 : 5000, run.seed);
    scene.precision_deg = degrees;
    return std::vector{scene};
  };
  return sweep(kDegreesApart, scenes_at, run, Flaw::mirrored);
}

}  // namespace

StabilityFamily huge_step_family() {
  return {"huge_step",
          "precision of the tables",
          "deg",
          "Entries are as exact as ever and errors below their bounds, which are large; a scheme that has no "
          "table so coarse, or of a step that does not divide its circles, says so.",
          kRadiusThreshold,
          kRadiusDerivation,
          {5.2, 0.92},
          describe(Flaw::mirrored),
          run_huge_step};
}

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// Directions on and beside two half-planes: where the azimuth jumps from 360 degrees to 0, and where an
// arctangent jumps from 180 to -180. With zeros of either sign and azimuths of one and two turns more.
#include <array>
#include <cmath>
#include <limits>

#include "mesh/bodies.hpp"
#include "stress/measure.hpp"
#include "stress/shapes.hpp"

namespace impinge::lab {
namespace {

constexpr std::array kSeamAngles{
    1e-4, 1e-8, 1e-12, 1e-16, 1e-30, 1e-300, std::numeric_limits<double>::denorm_min(), 0.0};

void add_beside(StabilityScene& scene, double phi, double angle) {
  for (const double x : {std::sin(phi), -std::sin(phi)}) {
    if (angle == 0.0) scene.twins.push_back({scene.directions.size(), scene.directions.size() + 1});
    for (const double sign : {1.0, -1.0}) scene.directions.emplace_back(x, sign * angle, std::cos(phi));
  }
  for (const double degrees : {0.0, 360.0, 720.0}) {
    for (const double sign : {1.0, -1.0})
      scene.directions.push_back(to_direction({phi, degrees * kDegree + sign * angle}));
  }
}

std::vector<StabilityCase> run_seam(const StabilityRun& run) {
  const int parallels = run.quick ? 15 : 90;
  const auto scenes_at = [parallels](double angle) {
    StabilityScene scene;
    scene.mesh = sphere(21.0, 300, {3.0, 2.0, -1.0});
    for (int k = 0; k < parallels; ++k) add_beside(scene, kPi * (k + 0.5) / parallels, angle);
    return std::vector{scene};
  };
  return sweep(kSeamAngles, scenes_at, run, Flaw::float_azimuth);
}

}  // namespace

StabilityFamily seam_family() {
  return {"seam",
          "angle beside the seam, at 0, 180, 360 and 720 degrees; 0: on it",
          "rad",
          "No column is missed or taken twice: errors stay below their bounds on both sides, and zeros of "
          "either sign give the same bits.",
          kRadiusThreshold,
          kRadiusDerivation,
          {5.2, 0.89},
          describe(Flaw::float_azimuth),
          run_seam};
}

}  // namespace impinge::lab

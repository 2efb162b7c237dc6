// SPDX-License-Identifier: GPL-3.0-or-later
// Directions close to and on the poles of the spherical angles, where azimuths lose their meaning and an
// arccosine loses half of its digits. The body has a vertex on each pole.
#include <array>
#include <cmath>

#include "mesh/bodies.hpp"
#include "stress/measure.hpp"
#include "stress/shapes.hpp"

namespace impinge::lab {
namespace {

constexpr std::array kPoleAngles{1e-2, 1e-3, 1e-4, 1e-8, 1e-12, 1e-16, 0.0};  // radians

TriangleMesh body() {
  return radial_body(300, [](const Vec3& u) { return 20.0 + 3.0 * u.x() - 2.0 * u.y() * u.z(); });
}

// At the poles: the same direction with zeros of either sign, written in four ways.
void add_poles(StabilityScene& scene) {
  for (const double z : {1.0, -1.0}) {
    const std::size_t first = scene.directions.size();
    for (const double x : {0.0, -0.0}) {
      for (const double y : {0.0, -0.0}) {
        scene.twins.push_back({first, scene.directions.size()});
        scene.directions.emplace_back(x, y, z);
      }
    }
  }
}

std::vector<StabilityCase> run_pole(const StabilityRun& run) {
  const int azimuths = run.quick ? 16 : 96;
  const auto scenes_at = [azimuths](double angle) {
    StabilityScene scene;
    scene.mesh = body();
    if (angle == 0.0) {
      add_poles(scene);
      return std::vector{scene};
    }
    for (int k = 0; k < azimuths; ++k) {
      const CosSin c = half_turn_fraction(2L * k, azimuths);
      for (const double z : {1.0, -1.0})
        scene.directions.emplace_back(std::sin(angle) * c.cos, std::sin(angle) * c.sin, z * std::cos(angle));
    }
    return std::vector{scene};
  };
  return sweep(kPoleAngles, scenes_at, run, Flaw::arccosine);
}

}  // namespace

StabilityFamily pole_family() {
  return {
      "pole",
      "angle from the pole; 0: on it",
      "rad",
      "No digit is lost at any distance from a pole; on it the answer does not depend on the azimuth nor on "
      "the sign of a zero, bit for bit.",
      kRadiusThreshold,
      kRadiusDerivation,
      {4.7, 0.92},
      describe(Flaw::arccosine),
      run_pole};
}

}  // namespace impinge::lab

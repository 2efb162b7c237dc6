// SPDX-License-Identifier: GPL-3.0-or-later
// Faces that a ray almost runs along. Each is aimed at an entry of a table: its plane makes 90 - psi with the
// direction and passes it 20 mm from the centre; it reaches 5 mm along the plane to either side, and 3 mm
// across. What it covers is about 90 - psi wide, so that only the aim meets it.
#include <array>
#include <cmath>

#include "stress/measure.hpp"
#include "stress/shapes.hpp"

namespace impinge::lab {

TriangleMesh near_tangent_face(const Vec3& aim, double beside) {
  const AimedFrame frame(aim);
  const Vec3 along = std::cos(beside) * frame.u + std::sin(beside) * frame.first;
  const Vec3 middle = kAimedRadius * frame.u;
  return {{middle + 5.0 * along, middle - 5.0 * along + 3.0 * frame.second,
           middle - 5.0 * along - 3.0 * frame.second},
          {{0, 1, 2}}};
}

namespace {

constexpr std::array kDegrees{1e0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12};

std::vector<StabilityCase> run_near_tangent(const StabilityRun& run) {
  const auto scenes_at = [&](double degrees) {
    StabilityScene scene;
    scene.mesh = backdrop();
    scene.directions = aimed_entries(scene.precision_deg, run.quick ? 3 : 12);
    for (const Vec3& aim : scene.directions) append(scene.mesh, near_tangent_face(aim, degrees * kDegree));
    return std::vector{scene};
  };
  return sweep(kDegrees, scenes_at, run);
}

}  // namespace

StabilityFamily near_tangent_family() {
  return {"near_tangent",
          "90 - psi of the faces that are met, psi from the direction to their normal",
          "deg",
          "The error grows as 1 + tan psi and no faster; no face is missed, none is met that is not there; "
          "bounds grow with tan psi.",
          kRadiusThreshold,
          kRadiusDerivation,
          {4.2, 0.81},
          run_near_tangent};
}

}  // namespace impinge::lab

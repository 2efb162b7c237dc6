// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that a ray almost runs along, each aimed at an entry of a table. The plane makes the angle e = 90
// - psi with the direction and passes it 20 mm from the centre, so it is visible up to e from the aim at
// most. Down to a tenth of a degree it is a wall that reaches 0.8 e about the aim, at most 8 degrees, so that
// a finer table answers; four more directions are tested half-way to its edge. Below, it is a face that
// reaches 5 mm along the plane to either side and 3 mm across, which only the aim meets.
#include <algorithm>
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

TriangleMesh near_tangent_wall(const Vec3& aim, double beside) {
  const AimedFrame frame(aim);
  const Vec3 normal = std::sin(beside) * frame.u - std::cos(beside) * frame.first;
  TriangleMesh mesh{{kAimedRadius * frame.u}, {}};
  for (std::size_t k = 0; k < kWallSides; ++k) {
    const CosSin c = half_turn_fraction(static_cast<long>(2 * k), static_cast<long>(kWallSides));
    const Vec3 beam = frame.u + std::tan(wall_reach(beside)) * (c.cos * frame.first + c.sin * frame.second);
    mesh.vertices.emplace_back(kAimedRadius * std::sin(beside) / normal.dot(beam) * beam);
    mesh.faces.push_back(
        {0, static_cast<VertexIndex>(1 + k), static_cast<VertexIndex>(1 + (k + 1) % kWallSides)});
  }
  return mesh;
}

double wall_reach(double beside) { return std::min(0.8 * beside, 8.0 * kDegree); }

namespace {

constexpr std::array kDegrees{30.0, 10.0, 3.0, 1.0, 0.3, 0.1, 1e-2, 1e-4, 1e-8, 1e-12};
constexpr double kLeastWall = 0.1;  // degrees

// Aims so far from earlier ones that their walls do not cover one another.
std::vector<Vec3> apart(const std::vector<Vec3>& aims, double angle) {
  std::vector<Vec3> kept;
  for (const Vec3& aim : aims) {
    if (std::ranges::none_of(kept, [&](const Vec3& other) { return angle_between(aim, other) < angle; }))
      kept.push_back(aim);
  }
  return kept;
}

void add_wall(StabilityScene& scene, const Vec3& aim, double beside) {
  append(scene.mesh, near_tangent_wall(aim, beside));
  const AimedFrame frame(aim);
  const double half = std::tan(0.5 * wall_reach(beside));
  scene.directions.push_back(aim);
  for (const Vec3& side : {frame.first, frame.second})
    for (const double sign : {-half, half}) scene.directions.emplace_back(frame.u + sign * side);
}

std::vector<StabilityCase> run_near_tangent(const StabilityRun& run) {
  const auto scenes_at = [&](double degrees) {
    StabilityScene scene;
    const double beside = degrees * kDegree;
    const std::vector<Vec3> aims = aimed_entries(scene.precision_deg, run.quick ? 3 : 12);
    if (degrees >= kLeastWall) {
      for (const Vec3& aim : apart(aims, 2.5 * wall_reach(beside))) add_wall(scene, aim, beside);
      return std::vector{scene};
    }
    scene.mesh = backdrop();
    scene.directions = aims;
    for (const Vec3& aim : aims) append(scene.mesh, near_tangent_face(aim, beside));
    return std::vector{scene};
  };
  return sweep(kDegrees, scenes_at, run, Flaw::steep_left_out);
}

}  // namespace

StabilityFamily near_tangent_family() {
  return {"near_tangent",
          "90 - psi of the faces that are met, psi from the direction to their normal",
          "deg",
          "The error grows as 1 + tan psi and no faster; no face is missed, none is met that is not there; "
          "the bound of a look-up grows with tan psi, until a table of its precision has no cell within the "
          "surface.",
          kRadiusThreshold,
          kRadiusDerivation,
          {4.2, 0.81},
          describe(Flaw::steep_left_out),
          run_near_tangent};
}

}  // namespace impinge::lab

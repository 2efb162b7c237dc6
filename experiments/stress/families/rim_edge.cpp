// SPDX-License-Identifier: GPL-3.0-or-later
// Directions on both sides of an edge at which a surface ends: the rim of a cup, and a hole in it. A library
// with rays in float cannot tell angles below 1e-7 apart; there it fails because of its input.
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "mesh/bodies.hpp"
#include "mesh/jump_edges.hpp"
#include "stress/measure.hpp"
#include "stress/shapes.hpp"

namespace impinge::lab {
namespace {

constexpr std::array kRimEdgeAngles{1.0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-15};  // radians

constexpr double kSide = 2.0;  // mm

// A cup about -z; the rest of the sphere is for faces aimed at entries.
TriangleMesh cup_with_hole() {
  TriangleMesh mesh = cup(25.0, 60.0, 240);
  for (Vec3& v : mesh.vertices) v = -v;
  mesh.faces.erase(mesh.faces.begin() + 20);
  return mesh;
}

// A face with one side at this angle from the direction, which meets the face, or misses it at a negative
// angle.
TriangleMesh face_beside(const Vec3& aim, double angle) {
  const AimedFrame frame(aim);
  const Vec3 edge = kAimedRadius * (frame.u + std::tan(angle) * frame.second);
  return {{edge + kSide * frame.first, edge - kSide * frame.first, edge - kSide * frame.second}, {{0, 1, 2}}};
}

StabilityScene along_rims(double angle) {
  StabilityScene scene;
  scene.mesh = cup_with_hole();
  for (const JumpEdge& edge : jump_edges(scene.mesh)) {
    const Vec3& from = scene.mesh.vertices[edge.from];
    const Vec3& to = scene.mesh.vertices[edge.to];
    const Vec3 at = (0.6 * from + 0.4 * to).normalized();
    const Vec3 across = from.cross(to).normalized();
    for (const double side : {-angle, angle})
      scene.directions.emplace_back(std::cos(side) * at + std::sin(side) * across);
  }
  return scene;
}

StabilityScene beside_entries(double angle, std::size_t each) {
  StabilityScene scene;
  std::size_t k = 0;
  for (const Vec3& aim : aimed_entries(scene.precision_deg, each)) {
    append(scene.mesh, face_beside(aim, ++k % 2 == 0 ? angle : -angle));
    scene.directions.push_back(aim);
  }
  return scene;
}

std::vector<StabilityCase> run_rim_edge(const StabilityRun& run) {
  const auto scenes_at = [&](double angle) {
    std::vector<StabilityScene> scenes{along_rims(angle)};
    if (angle * kAimedRadius < kSide) scenes.push_back(beside_entries(angle, run.quick ? 3 : 12));
    return scenes;
  };
  return sweep(kRimEdgeAngles, scenes_at, run, Flaw::loose_edges);
}

}  // namespace

StabilityFamily rim_edge_family() {
  return {
      "rim_edge",
      "angle between a direction and the edge at which the surface ends",
      "rad",
      "An entry and a ray meet the surface exactly if it is there; no look-up mixes radii across a rim: it "
      "answers nothing in a cell that a rim crosses, and nothing beyond.",
      kRadiusThreshold,
      kRadiusDerivation,
      {4.7, 0.88},
      describe(Flaw::loose_edges),
      run_rim_edge};
}

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// Faces with almost no area. The aspect of a sliver is its height over its length. Aspect 0 is three corners
// on one line, as nearly as doubles can be, and a face with two corners at one place. Slivers are aimed at
// entries of tables, and a closed body has one along a side of every face.
#include <algorithm>
#include <array>

#include "mesh/bodies.hpp"
#include "stress/measure.hpp"
#include "stress/shapes.hpp"

namespace impinge::lab {

TriangleMesh aimed_sliver(const Vec3& aim, double aspect) {
  constexpr double kHalf = 5.0;  // mm, half the length
  const AimedFrame frame(aim);
  const Vec3 height = 2.0 * kHalf * aspect * frame.second;
  const Vec3 foot = kAimedRadius * frame.u - height / 3.0;
  const Vec3 side = kHalf * frame.second;
  return {{foot + kHalf * frame.first, foot - kHalf * frame.first, foot + height, foot + side + height,
           foot - side},
          {{0, 1, 2}, {1, 0, 4}, {0, 2, 3}, {2, 1, 3}}};
}

StabilityScene slivered(const TriangleMesh& mesh, double aspect) {
  StabilityScene scene;
  scene.mesh.vertices = mesh.vertices;
  auto& [vertices, faces] = scene.mesh;
  for (const auto& [a, b, c] : mesh.faces) {
    const Vec3 middle = 0.5 * (vertices[a] + vertices[b]);
    const Vec3 across = vertices[c] - middle;
    const double share = std::min(aspect * (vertices[b] - vertices[a]).norm() / across.norm(), 0.5);
    const auto m = static_cast<VertexIndex>(vertices.size());
    vertices.emplace_back(middle + share * across);
    faces.insert(faces.end(), {{a, b, m}, {a, m, c}, {m, b, c}});
    scene.directions.emplace_back((vertices[a] + vertices[b] + vertices[m]) / 3.0);
    if (aspect > 0.0) continue;
    vertices.emplace_back(vertices[a]);
    faces.push_back({a, b, m + 1});
  }
  return scene;
}

namespace {

constexpr std::array kAspects{1e0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 0.0};

std::vector<StabilityCase> run_sliver(const StabilityRun& run) {
  const auto scenes_at = [&](double aspect) {
    StabilityScene aimed;
    aimed.mesh = backdrop();
    aimed.directions = aimed_entries(aimed.precision_deg, run.quick ? 2 : 8);
    for (const Vec3& aim : aimed.directions) append(aimed.mesh, aimed_sliver(aim, aspect));
    return std::vector{aimed, slivered(sphere(22.0, run.quick ? 100 : 400, {2.0, 1.0, -3.0}), aspect)};
  };
  return sweep(kAspects, scenes_at, run, Flaw::thin_left_out);
}

}  // namespace

StabilityFamily sliver_family() {
  return {
      "sliver",
      "height over length of faces; 0: corners on one line, and two corners at one place",
      "1",
      "Faces of no area cover nothing and leave no gap, their neighbours are met; a sliver answers as well "
      "as any face in its plane.",
      kRadiusThreshold,
      kRadiusDerivation,
      {5.7, 0.88},
      describe(Flaw::thin_left_out),
      run_sliver};
}

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "stress/stiff_surfaces.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <Eigen/Geometry>

#include "mesh/bodies.hpp"
#include "mesh/icosphere.hpp"
#include "mesh/jump_edges.hpp"
#include "sphere/as_floats.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/schemes/usid.hpp"
#include "stress/shapes.hpp"
#include "support/directions.hpp"
#include "support/soup.hpp"

namespace impinge::test {

using namespace lab;
namespace {

TriangleMesh in_floats(TriangleMesh mesh) {
  for (Vec3& v : mesh.vertices) v = as_floats(v);
  return mesh;
}

StiffSurface poles_and_seam() {
  StiffSurface surface{
      in_floats(radial_body(300, [](const Vec3& u) { return 20.0 + 3.0 * u.x() - 2.0 * u.y() * u.z(); }))};
  for (const double angle : {1e-2, 1e-4, 1e-8, 1e-16, 1e-30, 0.0})
    for (const double z : {1.0, -1.0, 0.3})
      for (const double sign : {1.0, -1.0})
        for (const double x : {std::sqrt(1.0 - z * z) + angle, -std::sqrt(1.0 - z * z) - angle})
          for (const Vec3& aim : {Vec3(x, sign * angle, z), Vec3(sign * angle, x, z)})
            surface.aims.push_back(aim);
  return surface;
}

// A cup and a hole in it, seen from both sides of their edges.
StiffSurface rims() {
  StiffSurface surface{in_floats(cup(25.0, 60.0, 240))};
  surface.mesh.faces.erase(surface.mesh.faces.begin() + 20);
  for (const JumpEdge& edge : jump_edges(surface.mesh)) {
    const Vec3& from = surface.mesh.vertices[edge.from];
    const Vec3& to = surface.mesh.vertices[edge.to];
    const Vec3 across = from.cross(to).normalized();
    for (const double angle : {1e-1, 1e-4, 1e-7, 1e-12})
      for (const double side : {-angle, angle})
        surface.aims.emplace_back((0.6 * from + 0.4 * to).normalized() + side * across);
  }
  return surface;
}

// Some entries of the tables that kernels read.
std::vector<Vec3> aimed_at() {
  std::vector<Vec3> aims;
  const auto add = [&aims](const auto& scheme) {
    for (const std::size_t k : {1U, 3U, 5U, 7U, 9U}) aims.push_back(scheme.direction(k * scheme.size() / 10));
  };
  add(CubeGnomonic::with_precision(kStiffPrecision));
  add(Rsid::with_precision(kStiffPrecision));
  add(Usid::with_precision(kStiffPrecision));
  return aims;
}

StiffSurface near_tangent(double degrees) {
  StiffSurface surface{backdrop()};
  surface.aims = aimed_at();
  for (const Vec3& aim : surface.aims) append(surface.mesh, near_tangent_face(aim, degrees * kDegree));
  return surface;
}

StiffSurface aimed_slivers(double aspect) {
  StiffSurface surface{backdrop()};
  surface.aims = aimed_at();
  for (const Vec3& aim : surface.aims) append(surface.mesh, aimed_sliver(aim, aspect));
  return surface;
}

StiffSurface slivers_everywhere(double aspect) {
  StabilityScene scene = slivered(sphere(22.0, 100, {2.0, 1.0, -3.0}), aspect);
  return {std::move(scene.mesh), Layer::farthest, std::move(scene.directions)};
}

// Towards a vertex on no axis, where the surface is near and steep.
StiffSurface off_centre(double offset) {
  StiffSurface surface{icosphere(22.0, 1)};
  const Vec3 near = surface.mesh.vertices[7];
  for (Vec3& v : surface.mesh.vertices) v -= offset * near;
  for (const Vec3& aside : random_directions(60, 22))
    surface.aims.emplace_back(near / 22.0 + 4.0 * std::fmax(1.0 - offset, 1e-7) * aside);
  return surface;
}

StiffSurface noise(double share) {
  return {noisy(sphere(22.0, 300, {2.0, -3.0, 1.0}), share, 1), Layer::farthest};
}

}  // namespace

std::span<const StiffFamily> stiff_families() {
  static constexpr std::array kFamilies{
      StiffFamily{"PolesAndSeam", poles_and_seam},
      StiffFamily{"Dyadic",
                  [] {
                    return StiffSurface{dyadic_body(), Layer::farthest};
                  }},
      StiffFamily{"Rims", rims},
      StiffFamily{"NearTangent1", [] { return near_tangent(1.0); }},
      StiffFamily{"NearTangent1e4", [] { return near_tangent(1e-4); }},
      StiffFamily{"NearTangent1e11", [] { return near_tangent(1e-11); }},
      StiffFamily{"AimedSlivers1e2", [] { return aimed_slivers(1e-2); }},
      StiffFamily{"AimedSlivers1e8", [] { return aimed_slivers(1e-8); }},
      StiffFamily{"AimedSlivers0", [] { return aimed_slivers(0.0); }},
      StiffFamily{"Slivers1e6", [] { return slivers_everywhere(1e-6); }},
      StiffFamily{"Slivers0", [] { return slivers_everywhere(0.0); }},
      StiffFamily{"OffCentre", [] { return off_centre(0.9); }},
      StiffFamily{"OffCentreAlmostAll", [] { return off_centre(0.999999); }},
      StiffFamily{"Fold", [] { return StiffSurface{pleated(5)}; }},
      StiffFamily{"Soup", [] { return StiffSurface{soup(40, 7)}; }},
      StiffFamily{"Noise1Percent", [] { return noise(0.01); }},
      StiffFamily{"Noise30Percent", [] { return noise(0.3); }}};
  return kFamilies;
}

}  // namespace impinge::test

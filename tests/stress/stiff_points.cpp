// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstddef>

#include "sphere/as_floats.hpp"
#include "stress/stiff_surfaces.hpp"
#include "support/directions.hpp"

namespace impinge::test {

using namespace lab;
namespace {

constexpr std::size_t kMost = 250;  // points of a kind

Vec3 at_length(const Vec3& direction, std::size_t k) {
  static constexpr std::array kLengths{20.0, 21.75, 22.0, 25.0, 45.0, 0.5, 1e-9, 1e9};  // mm
  return as_floats(kLengths[k % kLengths.size()] * direction.stableNormalized());
}

}  // namespace

std::vector<Vec3> stiff_points(const StiffSurface& surface) {
  std::vector<Vec3> directions = surface.aims;
  for (const Vec3& x : special_directions()) directions.push_back(x);
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 0.0, 1.0})
      for (const double z : {-1.0, 0.0, 1.0})
        if (x != 0.0 || y != 0.0 || z != 0.0) directions.emplace_back(x, y, z);
  for (const Vec3& x : random_directions(kMost, 5)) directions.push_back(x);
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < directions.size(); ++k) points.push_back(at_length(directions[k], k));
  const TriangleMesh& mesh = surface.mesh;
  for (std::size_t v = 0; v < mesh.vertices.size(); v += mesh.vertices.size() / kMost + 1)
    points.push_back(as_floats(mesh.vertices[v]));
  for (std::size_t f = 0; f < mesh.faces.size(); f += mesh.faces.size() / kMost + 1)
    points.push_back(as_floats(0.5 * (corner(mesh, mesh.faces[f], 0) + corner(mesh, mesh.faces[f], 1))));
  std::erase_if(points, [](const Vec3& x) { return x.isZero(0.0); });
  return points;
}

}  // namespace impinge::test

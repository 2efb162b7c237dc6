// SPDX-License-Identifier: GPL-3.0-or-later
#include "stress/shapes.hpp"

#include <algorithm>

#include <Eigen/Geometry>

#include "mesh/bodies.hpp"
#include "stress/methods.hpp"

namespace impinge::lab {

AimedFrame::AimedFrame(const Vec3& direction)
    : u(direction.normalized()), first(u.unitOrthogonal()), second(u.cross(first)) {}

std::vector<Vec3> aimed_entries(double precision_deg, std::size_t each) {
  std::vector<Vec3> aims;
  for (const auto& [scheme, directions] : scheme_entries(precision_deg)) {
    const std::size_t count = std::min(each, directions.size());
    for (std::size_t k = 0; k < count; ++k) {
      const Vec3& aim = directions[(2 * k + 1) * directions.size() / (2 * count)];
      if (std::ranges::find(aims, aim) == aims.end()) aims.push_back(aim);
    }
  }
  return aims;
}

void append(TriangleMesh& mesh, const TriangleMesh& more) {
  const auto first = static_cast<VertexIndex>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const Face& face : more.faces)
    mesh.faces.push_back({first + face[0], first + face[1], first + face[2]});
}

TriangleMesh backdrop() { return sphere(45.0, 300); }

}  // namespace impinge::lab

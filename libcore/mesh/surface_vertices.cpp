// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface_vertices.hpp"

#include <cstddef>

namespace impinge {

bool is_edge_on(const TriangleMesh& mesh, const Face& face) {
  return orientation(corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2)) == 0;
}

TriangleMesh without_edge_on(TriangleMesh mesh) {
  std::erase_if(mesh.faces, [&mesh](const Face& face) { return is_edge_on(mesh, face); });
  return mesh;
}

std::vector<bool> on_surface(const TriangleMesh& mesh) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const Face& face : mesh.faces) {
    if (is_edge_on(mesh, face)) continue;
    for (const VertexIndex v : face) used[v] = true;
  }
  return used;
}

std::vector<VertexIndex> surface_vertices(const TriangleMesh& mesh) {
  const std::vector<bool> used = on_surface(mesh);
  std::vector<VertexIndex> found;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v]) found.push_back(static_cast<VertexIndex>(v));
  }
  return found;
}

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface_vertices.hpp"

#include <cstddef>

namespace impinge {

std::vector<bool> on_surface(const TriangleMesh& mesh) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const Face& face : mesh.faces) {
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

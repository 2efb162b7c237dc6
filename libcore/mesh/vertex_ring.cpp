// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/vertex_ring.hpp"

namespace impinge {

void stitch(TriangleMesh& mesh, VertexRing upper, VertexRing lower) {
  const auto length = [&mesh](VertexIndex a, VertexIndex b) {
    return (mesh.vertices[a] - mesh.vertices[b]).squaredNorm();
  };
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < upper.steps() || j < lower.steps()) {
    const bool along_upper = j == lower.steps() || (i < upper.steps() && length(upper[i + 1], lower[j]) <
                                                                             length(upper[i], lower[j + 1]));
    mesh.faces.push_back({upper[i], lower[j], along_upper ? upper[i + 1] : lower[j + 1]});
    ++(along_upper ? i : j);
  }
}

}  // namespace impinge

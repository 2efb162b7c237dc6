// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/loft.hpp"

#include <stdexcept>

#include "mesh/vertex_ring.hpp"

namespace impinge {

TriangleMesh loft(std::span<const std::vector<Vec3>> rings) {
  if (rings.size() < 2) throw std::invalid_argument("a surface needs two rings of points or more");
  TriangleMesh mesh;
  VertexRing before{0, 0};
  for (const std::vector<Vec3>& points : rings) {
    const VertexRing ring{mesh.vertices.size(), points.size()};
    if (points.empty() || points.size() == 2 || (points.size() == 1 && before.size == 1)) {
      throw std::invalid_argument("a ring is one point beside a larger ring, or three points or more");
    }
    mesh.vertices.insert(mesh.vertices.end(), points.begin(), points.end());
    if (before.size > 0) stitch(mesh, before, ring);
    before = ring;
  }
  return mesh;
}

}  // namespace impinge

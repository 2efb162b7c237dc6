// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/loft.hpp"

#include <stdexcept>

namespace impinge {
namespace {

// Points from index `first`, read cyclically.
struct Ring {
  std::size_t first;
  std::size_t size;
  // Faces along a ring: a pole has none.
  std::size_t steps() const { return size == 1 ? 0 : size; }
  VertexIndex operator[](std::size_t k) const { return static_cast<VertexIndex>(first + k % size); }
};

void stitch(TriangleMesh& mesh, Ring upper, Ring lower) {
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

}  // namespace

TriangleMesh loft(std::span<const std::vector<Vec3>> rings) {
  if (rings.size() < 2) throw std::invalid_argument("a surface needs two rings of points or more");
  TriangleMesh mesh;
  Ring before{0, 0};
  for (const std::vector<Vec3>& points : rings) {
    const Ring ring{mesh.vertices.size(), points.size()};
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

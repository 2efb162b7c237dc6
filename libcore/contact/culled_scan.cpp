// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/culled_scan.hpp"

#include "mesh/lengths.hpp"
#include "mesh/surface_vertices.hpp"

namespace impinge {
namespace {

// Returns the mesh, after a check that floats can hold its lengths.
const TriangleMesh& checked(const TriangleMesh& mesh) {
  require_float_lengths(mesh);
  return mesh;
}

CapTree tree_of(const TriangleMesh& mesh) {
  std::vector<CapItem> items;
  for (const std::uint32_t v : surface_vertices(mesh)) {
    const double length = mesh.vertices[v].norm();
    items.push_back({{mesh.vertices[v].stableNormalized(), 0.0}, {length, length}});  // none is at the centre
  }
  return CapTree(items);
}

}  // namespace

CulledScan::CulledScan(Surface scanned, const TriangleMesh& vertices_of, const TriangleMesh& facing)
    : scanned_(scanned),
      tree_(tree_of(checked(vertices_of))),
      limits_(checked(facing), facing_layer(other(scanned))) {
  const std::vector<std::uint32_t> used = surface_vertices(vertices_of);
  for (const std::uint32_t item : tree_.order()) {
    vertex_.push_back(used[item]);
    position_.push_back(vertices_of.vertices[used[item]]);
  }
}

std::size_t CulledScan::bytes() const {
  return tree_.bytes() + limits_.bytes() + vertex_.size() * sizeof(std::uint32_t) +
         position_.size() * sizeof(Vec3);
}

}  // namespace impinge

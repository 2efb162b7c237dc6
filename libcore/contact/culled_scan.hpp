// SPDX-License-Identifier: GPL-3.0-or-later
// One scan, prepared to decide whole caps of its vertices at once: a tree of the vertices of one surface, and
// the limits of the other surface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "contact/cap_limits.hpp"
#include "contact/cap_tree.hpp"
#include "gap/surface.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// A vertex of one of the surfaces.
struct ScannedVertex {
  Surface scanned = Surface::ball;  // whose vertex it is
  std::size_t vertex = 0;           // its number in the mesh
  bool operator==(const ScannedVertex&) const = default;
};

class CulledScan {
 public:
  /// Takes meshes in their centre frames, mm. Vertices of no face are left out. Throws std::invalid_argument
  /// for lengths outside of the range of floats in mesh/lengths.hpp.
  CulledScan(Surface scanned, const TriangleMesh& vertices_of, const TriangleMesh& facing);

  Surface scanned() const { return scanned_; }         // whose vertices are scanned
  const CapTree& tree() const { return tree_; }        // of the scanned vertices
  const CapLimits& limits() const { return limits_; }  // of the other surface
  /// Number in the mesh of item `item` in the order of the tree.
  std::uint32_t vertex(std::size_t item) const { return vertex_[item]; }
  /// Where that vertex is in its mesh, mm.
  const Vec3& position(std::size_t item) const { return position_[item]; }
  std::size_t bytes() const;  // of memory

 private:
  Surface scanned_;
  CapTree tree_;
  CapLimits limits_;
  std::vector<std::uint32_t> vertex_;
  std::vector<Vec3> position_;
};

}  // namespace impinge

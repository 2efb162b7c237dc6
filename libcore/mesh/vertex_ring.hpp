// SPDX-License-Identifier: GPL-3.0-or-later
// Rings of vertices, and the band of triangles between two of them.
#pragma once

#include <cstddef>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// `size` vertices from index `first` on, read cyclically; a ring of one vertex is a pole.
struct VertexRing {
  std::size_t first;  // index of the first vertex
  std::size_t size;   // number of vertices, 1 or more

  std::size_t steps() const { return size == 1 ? 0 : size; }  // faces along the ring; a pole has none
  /// Index of vertex k; k beyond the end wraps round.
  VertexIndex operator[](std::size_t k) const { return static_cast<VertexIndex>(first + k % size); }
};

/// Appends the band between two rings, at each step with the shorter of the two possible diagonals. Normals
/// point outward if the points run counter-clockwise as seen from outside, from beyond `upper`.
void stitch(TriangleMesh& mesh, VertexRing upper, VertexRing lower);

}  // namespace impinge

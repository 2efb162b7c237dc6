// SPDX-License-Identifier: GPL-3.0-or-later
// One vertex instead of several at the same place.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

struct Weld {
  TriangleMesh mesh;                // the vertices that were kept, in their order, moved nowhere
  std::vector<VertexIndex> map;     // old index to new index
  std::size_t merged_vertices = 0;  // that were not kept
  std::size_t collapsed_faces = 0;  // left out because two of their corners became one, or were one before
};

/// Merges vertices with equal coordinates (-0 equals 0) into the first of them. A vertex with a NaN stays
/// alone. Vertices of no face are kept. Throws std::out_of_range when a face names a vertex that does not
/// exist.
Weld weld(const TriangleMesh& mesh);

/// Goes through the vertices in their order and merges each into the nearest one kept so far (of equally near
/// ones the first) if that is within tolerance, else keeps it. So no vertex moves further than the tolerance,
/// and all that are kept are further apart than that. tolerance: mm, positive and finite, else
/// std::invalid_argument.
Weld weld(const TriangleMesh& mesh, double tolerance);

}  // namespace impinge

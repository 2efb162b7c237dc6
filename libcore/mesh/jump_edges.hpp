// SPDX-License-Identifier: GPL-3.0-or-later
// Edges at which the radius, seen from the centre, may end or jump.
#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// An edge of a rim (one face), of a fold (two faces on the same side of the plane through the centre and the
/// edge), or of a non-manifold place. Everywhere else the radius of a surface layer is continuous.
struct JumpEdge {
  VertexIndex from = 0;  // an end
  VertexIndex to = 0;    // the other end
  double slope = 0.0;    // largest tan psi of the faces at the edge, infinite if one is edge-on
};

/// The edge as the centre sees it: a cone that covers no area.
inline TriangleCone cone_of(const TriangleMesh& mesh, const JumpEdge& edge) {
  return {mesh.vertices[edge.from], mesh.vertices[edge.to], mesh.vertices[edge.to]};
}

/// The jump edges of a mesh in the centre frame. Sides are decided exactly; the orientation of faces is
/// ignored. Sorted by the smaller of the two ends, then by the larger one.
std::vector<JumpEdge> jump_edges(const TriangleMesh& mesh);

}  // namespace impinge

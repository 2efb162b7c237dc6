// SPDX-License-Identifier: GPL-3.0-or-later
// Decides which faces and vertices of a mesh count as its surface. A face that is edge-on in the centre frame
// of its own mesh, at rest, covers no direction and is left out in every pose (see gap/overlay.hpp for
// contact). A vertex that only such faces use, or no face, is not on the surface and has no gap.
#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Does the plane of the face hold the centre, or has the face no area? Exact. `mesh` is in the centre frame.
bool is_edge_on(const TriangleMesh& mesh, const Face& face);

/// The surface: the mesh without its edge-on faces. Vertices keep their numbers.
TriangleMesh without_edge_on(TriangleMesh mesh);

/// For each vertex: is it a corner of a face that is not edge-on? The corners of all faces must exist.
std::vector<bool> on_surface(const TriangleMesh& mesh);

/// The vertices on the surface, in the order of the mesh.
std::vector<VertexIndex> surface_vertices(const TriangleMesh& mesh);

}  // namespace impinge

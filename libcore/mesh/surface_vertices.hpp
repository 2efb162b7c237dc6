// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces and vertices of a mesh count as its surface. A face that is edge-on in the centre frame of its
// own mesh, at rest, covers no direction and is left out in every pose; what that means for contact is said
// in gap/overlay.hpp. A vertex that only such faces use, or none, is not on the surface and has no gap.
#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Does the plane of the face hold the centre, or has it no area? Exact; mesh in the centre frame.
bool is_edge_on(const TriangleMesh& mesh, const Face& face);

/// The surface: the mesh without its edge-on faces. Vertices keep their places.
TriangleMesh without_edge_on(TriangleMesh mesh);

/// One value a vertex: is it a corner of a face that is not edge-on? Corners of all faces exist.
std::vector<bool> on_surface(const TriangleMesh& mesh);

/// The vertices on the surface, in the order of the mesh.
std::vector<VertexIndex> surface_vertices(const TriangleMesh& mesh);

}  // namespace impinge

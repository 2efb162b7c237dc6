// SPDX-License-Identifier: GPL-3.0-or-later
// Which vertices of a mesh are on its surface: those of a face. A vertex of no face belongs to no surface,
// and has no gap.
#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

// One value a vertex: is it a corner of a face? Corners of all faces exist.
std::vector<bool> on_surface(const TriangleMesh& mesh);

// Those that are, in the order of the mesh.
std::vector<VertexIndex> surface_vertices(const TriangleMesh& mesh);

}  // namespace impinge

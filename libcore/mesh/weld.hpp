// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces several vertices at the same place, or several faces with the same corners, by one.
#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// For each vertex the first vertex with equal coordinates (-0 equals 0); a vertex with a NaN is its own.
std::vector<VertexIndex> first_at_place(const std::vector<Vec3>& vertices);

/// Merges vertices with equal coordinates (-0 equals 0) into the first of them, and leaves out faces two of
/// whose corners become one. A vertex with a NaN is never merged. Vertices of no face are kept; the order
/// stays. Throws std::out_of_range if a face names a vertex that does not exist.
TriangleMesh weld(const TriangleMesh& mesh);

/// The first of all faces with the same corners, whichever way round.
TriangleMesh without_repeats(TriangleMesh mesh);

/// A mesh and what continues it: where vertices of the two lie at one place, those of the first are used. The
/// first mesh keeps its vertices and faces, which come first.
TriangleMesh continued(TriangleMesh mesh, const TriangleMesh& rest);

}  // namespace impinge

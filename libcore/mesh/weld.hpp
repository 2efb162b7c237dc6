// SPDX-License-Identifier: GPL-3.0-or-later
// One vertex instead of several at the same place.
#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// For each vertex the first one with equal coordinates (-0 equals 0); one with a NaN is its own.
std::vector<VertexIndex> first_at_place(const std::vector<Vec3>& vertices);

/// Merges vertices with equal coordinates (-0 equals 0) into the first of them; faces of which two corners
/// become one are left out. A vertex with a NaN is never merged. Vertices of no face are kept; the order
/// stays. Throws std::out_of_range if a face names a vertex that does not exist.
TriangleMesh weld(const TriangleMesh& mesh);

}  // namespace impinge

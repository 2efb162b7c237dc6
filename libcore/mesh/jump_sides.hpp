// SPDX-License-Identifier: GPL-3.0-or-later
// Which sides of each face the radius may end or jump at.
#pragma once

#include <array>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// For each face, whether its side from corner k to corner k + 1 is one of jump_edges(). Where no such side
/// is near, the surface goes on: a set of directions that is connected, meets the surface and no jump edge is
/// covered by it whole. For were it not, the surface would end in it at an edge of a face, or at a corner
/// round which the faces do not close. mesh in the centre frame.
std::vector<std::array<bool, 3>> jump_sides(const TriangleMesh& mesh);

}  // namespace impinge

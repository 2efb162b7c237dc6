// SPDX-License-Identifier: GPL-3.0-or-later
// The few edges of a surface that are not the common side of just two faces beside each other, found without
// sorting the others.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// For each vertex, whether an edge that it is the lower end of (that of the smaller place) is unpaired: not
/// used by two faces alone, or by both in the same direction once the faces of side -1 are turned round, or
/// by one of side 0. A vertex that is the lower end of more than 64 edges is said to have one in any case.
/// `sides` of the faces: +1, -1 or 0; 0 for those without three corners, which use no edge. Takes linear
/// time. std::invalid_argument for more faces than a third of 2^32.
std::vector<bool> unpaired_lower_ends(const TriangleMesh& mesh, std::span<const std::int8_t> sides);

}  // namespace impinge

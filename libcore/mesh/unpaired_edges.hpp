// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of a surface that do not join exactly two faces beside each other, found without sorting all
// edges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// One value a vertex: is it the lower end (the one with the smaller index) of an unpaired edge? An edge is
/// unpaired if it is not used by exactly two faces, if both run through it in the same direction once faces
/// of side -1 are turned round, or if one is of side 0. The lower end of more than 64 edges may count as
/// having one in any case. `sides`: +1, -1 or 0 a face; 0 for faces without three corners, which use no edge.
/// Takes linear time. std::invalid_argument for more faces than a third of 2^32.
std::vector<bool> unpaired_lower_ends(const TriangleMesh& mesh, std::span<const std::int8_t> sides);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the edges of a surface that do not join exactly two faces beside each other, without sorting all
// edges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// For each vertex: is it the lower end (the one with the smaller index) of an unpaired edge? An edge is
/// unpaired if it is not used by exactly two faces, if both run through it in the same direction once faces
/// of side -1 are turned round, or if one has side 0. A vertex of very many edges may count as the end of one
/// in any case. `sides` has +1, -1 or 0 for each face; it must be 0 for faces without three corners, which
/// use no edge. Takes linear time. Throws std::invalid_argument for more faces than a third of 2^32.
std::vector<bool> unpaired_lower_ends(const TriangleMesh& mesh, std::span<const std::int8_t> sides);

}  // namespace impinge

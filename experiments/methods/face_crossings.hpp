// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces of one mesh cross each other, exactly: the reference for self-collision.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// Pairs of faces without a common vertex that share a point, by exact predicates; each once, the smaller
// index first, in order. Exactly degenerate faces cross nothing.
std::vector<std::pair<std::size_t, std::size_t>> face_crossings(const TriangleMesh& mesh);

}  // namespace impinge::lab

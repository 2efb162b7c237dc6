// SPDX-License-Identifier: GPL-3.0-or-later
// How the faces of a mesh are put into blocks; see exact_cells.hpp.
#pragma once

#include "gap/simd/exact_cells.hpp"
#include "gap/simd/seen_planes.hpp"

namespace impinge {

/// Block after block of the faces in this order.
std::vector<FaceBlock> face_blocks(const SeenMesh& seen, std::span<const std::uint32_t> order, Layer layer);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// In which cells of a grid on a cube a surface may end.
#pragma once

#include <vector>

#include "gap/simd/hit_cells.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// For the entry that each cell begins at: may the surface cover only a part of its directions, or jump there
/// from one layer to another, or be seen so steeply that its radius in double is not certain to the digits of
/// a float? In all other cells either every direction meets a face or none does. mesh in the centre frame.
std::vector<bool> open_cells(const TriangleMesh& mesh, CellGrid grid);

}  // namespace impinge

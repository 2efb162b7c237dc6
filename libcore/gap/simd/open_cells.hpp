// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the cells of a grid on a cube in which a surface may end.
#pragma once

#include <vector>

#include "gap/simd/hit_cells.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// For the entry at which each cell begins: may the surface cover only a part of the cell, or jump there from
/// one layer to another, or be seen so steeply that its radius in double is uncertain in the digits of a
/// float? In all other cells either every direction meets a face or none does. `mesh` is in the centre frame.
std::vector<bool> open_cells(const TriangleMesh& mesh, CellGrid grid);

}  // namespace impinge

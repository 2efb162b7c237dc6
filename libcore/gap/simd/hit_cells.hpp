// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the cells of a grid on a cube in which a face may be met.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "sphere/lists.hpp"
#include "sphere/triangle_cone.hpp"

namespace impinge {

/// A cube with n = `divisions` cells along each edge. A cell is named by the entry of `cube_gnomonic` at
/// which it begins: (face (n + 1) + row) (n + 1) + column. Places on the grid may be off by `margin` cells.
struct CellGrid {
  std::size_t divisions;  // cells along an edge
  double margin;          // cells
};

/// A grid whose margin covers the places of a kernel in float, which are off by 6.5 u times the cells of an
/// edge (gap_kernels.hpp).
inline CellGrid float_grid(std::size_t divisions) {
  return {divisions, 1e-6 + 7.0 * 0x1p-24 * static_cast<double>(divisions)};
}

/// Appends to `cells`, row by row and each once, every cell that holds a direction of the cone, or may seem
/// to if places are off by the margin, and few others.
void add_hit_cells(const CellGrid& grid, const TriangleCone& cone, std::vector<std::uint32_t>& cells);

/// Lists, for the entry at which each cell begins, which of these faces may be met in the cell, in their
/// order. `mesh` is in the centre frame.
Lists faces_of_cells(const TriangleMesh& mesh, std::span<const std::uint32_t> faces, const CellGrid& grid);

}  // namespace impinge

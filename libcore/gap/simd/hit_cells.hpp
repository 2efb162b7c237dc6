// SPDX-License-Identifier: GPL-3.0-or-later
// Which cells of a grid on a cube a face may be met in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "sphere/lists.hpp"
#include "sphere/triangle_cone.hpp"

namespace impinge {

/// Cells of a cube with `divisions` cells along an edge, named by the entry of `cube_gnomonic` that they
/// begin at: (6-fold face, row, column) -> (face (n + 1) + row) (n + 1) + column.
///
/// Places on the grid may be off by `margin` cells.
struct CellGrid {
  std::size_t divisions;  // cells along an edge
  double margin;          // cells
};

/// A grid whose margin covers places that a kernel works out in float, which are off by 6.5 u times the cells
/// of an edge (gap_kernels.hpp).
inline CellGrid float_grid(std::size_t divisions) {
  return {divisions, 1e-6 + 7.0 * 0x1p-24 * static_cast<double>(divisions)};
}

/// Appends to `cells` every cell that holds a direction of the cone, or may seem to with places off by the
/// margin, and few others; in order of the rows, each once.
void add_hit_cells(const CellGrid& grid, const TriangleCone& cone, std::vector<std::uint32_t>& cells);

/// For the entry that each cell begins at: those of these faces, by number and in their order, that the cell
/// may meet. mesh in the centre frame.
Lists faces_of_cells(const TriangleMesh& mesh, std::span<const std::uint32_t> faces, const CellGrid& grid);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Which cells of a grid on a cube a face may be met in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sphere/triangle_cone.hpp"

namespace impinge {

// Cells of a cube with `divisions` cells along an edge, named by the entry of `cube_gnomonic` that they begin
// at: (6-fold face, row, column) -> (face (n + 1) + row) (n + 1) + column.
//
// Appends to `cells` every cell that some direction of the cone is in, or comes to be in by a place on the
// grid that is off by `margin` cells; few others, in order of the rows, each once.
struct CellGrid {
  std::size_t divisions;
  double margin;
};
void add_cells_met(const CellGrid& grid, const TriangleCone& cone, std::vector<std::uint32_t>& cells);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/simd/open_cells.hpp"

#include <cstdint>

#include "mesh/jump_edges.hpp"

namespace impinge {

namespace {

// Up to this tan psi a radius in double, off by 84 2^-53 (1 + tan psi) of itself (table/error_bound.hpp), is
// within the 18 2^-24 of exact_cells.hpp.
constexpr double kSteepestInDouble = 1e8;

}  // namespace

std::vector<bool> open_cells(const TriangleMesh& mesh, CellGrid grid) {
  grid.margin *= 2.0;  // a cell is surely open if a face ends in its margin
  std::vector<std::uint32_t> cells;
  for (const JumpEdge& edge : jump_edges(mesh)) add_hit_cells(grid, cone_of(mesh, edge), cells);
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    if (cone.edge_on() || cone.largest_slope() > kSteepestInDouble) add_hit_cells(grid, cone, cells);
  }
  const std::size_t lines = grid.divisions + 1;
  std::vector<bool> open(6 * lines * lines);
  for (const std::uint32_t cell : cells) open[cell] = true;
  return open;
}

}  // namespace impinge

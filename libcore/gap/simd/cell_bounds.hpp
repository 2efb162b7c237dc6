// SPDX-License-Identifier: GPL-3.0-or-later
// Proven bounds on the error of a table of inverse depths, cell by cell, in one pass over the faces.
//
// A plane q . x = 1 has the number q . P at the point P of the cube, linear in the place on a face of the
// cube. So has the face that is met at P. Bilinear weights lambda_k reproduce its number from those at the
// corners c_k of the cell, and the table, which keeps v_k there, is off by
//   |sum lambda_k (v_k - q . c_k)| <= e = max |v_k - q . c_k|,
// the maximum over the corners and over all faces that the cell may meet. In a cell that the surface covers
// and in which it does not jump (open_cells.hpp) that is no more than what its planes differ by. With m the
// least v_k the radius is off by |P| e / (m (m - e)) at most; beyond e = m nothing is proven.
//
// Hidden faces do not count. No sheet of faces that are joined by edges ends in such a cell, so that each
// covers it: the nearest layer is no farther than any sheet, and a face behind all planes of one of them, at
// every corner, is met nowhere (the farthest layer likewise).
#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "sphere/stored_table.hpp"
#include "table/layer.hpp"

namespace impinge {

/// What is proven of a cell that is not open.
struct CellBound {
  double mm = 0.0;        // |answer of the table - radius of the layer|; infinite where nothing is proven
  double steepest = 1.0;  // largest number in the cell, of the table or a plane, over the least
};

/// For the entry that each cell begins at; {} in cells without an answer. mesh in the centre frame; the table
/// was filled exactly from it, for this layer. Directions count for a cell as on float_grid()
/// (hit_cells.hpp).
std::vector<CellBound> cell_bounds(const TriangleMesh& mesh, Layer layer,
                                   const InverseDepthTable<CubeGnomonic>& table);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Tables whose errors are centred about 0: half as large at the edges of a surface that is convex or concave,
// with the same memory and look-up.
//
// `mesh_exact` reproduces flat faces, so that its errors are at edges alone, and of one sign: where a surface
// is convex, its inverse depth y lies on one side of the interpolation Y between its entries. Let
//   l <= y - Y <= h,  l <= 0 <= h
// in a cell, and let L and H be the least l and the largest h of it and the cells around it. Each entry is
// raised by half the sum of the least l and the largest h of the cells that read it, which is within
// [(L + h) / 2, (l + H) / 2] for each of these cells. So is the mean of such changes in a cell, and
//   (l - H) / 2 <= y - Y' <= (h - L) / 2
// with the new interpolation Y': the largest error, H or -L, does not grow, and is halved where L or H is 0.
// No other entries do better there: to move Y by more than half of its error, one entry has to move as much.
// In mm the error is r^2 depth (y - Y) to first order: the above holds but for the change of r^2 depth
// between neighbouring cells.
//
// l and h are exact. On the part of a flat face in a cell y is affine and Y bilinear, so that y - Y is
// largest and least on the border of that part: on a side of the cell, where it is linear, at an end; along
// an edge of the mesh, where it is quadratic, at an end or where its derivative is 0. (The surface
// changes from face to face at edges: one where faces pass through each other is not looked at.)
#pragma once

#include "mesh/triangle_mesh.hpp"
#include "sphere/schemes/cube_equiangular.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "sphere/stored_table.hpp"
#include "table/layer.hpp"

namespace impinge::lab {

// Centres the table `filled`, which is fill_exact(mesh, scheme, layer). Cells without an answer do not count;
// entries that only such cells read keep their value. No entry loses more than half of its value, and entries
// in the same direction stay equal. Bounds that need exact entries (error_bound.hpp) no longer hold; those of
// table_bound.hpp do. O(faces + cells that edges run through).
template <PlaneExactScheme S>
RadialTable<S> centred_table(const TriangleMesh& mesh, RadialTable<S> filled, Layer layer);

}  // namespace impinge::lab

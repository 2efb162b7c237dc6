// SPDX-License-Identifier: GPL-3.0-or-later
// A face of a mesh as the raster of a tile draws it: three edge functions and the inverse depth, all affine
// over the grid, in float, from the first entry of its window on.
//
// Certainty. Corners are at their places on the grid to within e = 2^-49 n cells (at most 4.5 n cells, four
// roundings), entries to within e as well (fill_exact() looks along their rounded unit vectors). With w and h
// the columns and rows of the window and X + Y the extents of the face, an edge function is then off by at
// most
//   8 u (|E| + |E_x| w + |E_y| h) + e (5 (X + Y) + 4),   u = 2^-24
// (each of its three terms is rounded five times at most). Between +- this `doubt` the exact test decides.
//
// Inverse depth. Its value is off by at most 5 u (|q| + |q_x| w + |q_y| h), of which the terms are never more
// than kMostTerms times the least q at a corner: 40 u = 2.4e-6 of q. Faces that are steeper, or so thin that
// gradient or orientation is not certain, are `unclear`, and are drawn in double by the exact test.
#pragma once

#include <array>
#include <cstdint>

#include "kernels/cube_view.hpp"

namespace impinge {

inline constexpr double kMostTerms = 8.0;  // see above

// A face ready to be drawn into a tile.
struct TileTriangle {
  std::array<float, 3> edge{};     // at the first entry; above zero inside
  std::array<float, 3> edge_x{};   // from a column to the next
  std::array<float, 3> edge_y{};   // from a row to the next
  float q = 0.0F;                  // 1 / mm, the same
  float q_x = 0.0F;                // from a column to the next
  float q_y = 0.0F;                // from a row to the next
  float doubt = 0.0F;              // of an edge function, see above
  std::uint32_t face = 0;          // of the mesh
  std::uint16_t first_column = 0;  // of the tile
  std::uint16_t first_row = 0;     // likewise
  std::uint16_t columns = 0;       // of the window
  std::uint16_t rows = 0;          // of the window
};

// The inverse depth over the plane of a face: q + q_x (x - x_0) + q_y (y - y_0), from corner 0 on.
struct SeenPlane {
  double q_x = 0.0;    // 1 / mm a column
  double q_y = 0.0;    // 1 / mm a row
  double side = 0.0;   // +1 or -1: which way the corners go round, on the grid
  bool clear = false;  // are all these certain?
};
SeenPlane plane_of(const SeenFace& seen, std::size_t divisions);  // of a face whose corners are known

// The part of the window within the tile; empty where there is none.
GridWindow window_in(const CubeTile& tile, const GridWindow& window);

// Fills `drawn` but for its `face`; false where it is unclear. `window` is within the tile.
bool set_up(const SeenFace& seen, const GridWindow& window, std::size_t divisions, TileTriangle& drawn);

// Least and largest inverse depth of a face in its window, 1 / mm, from outside.
struct DepthRange {
  double least = 0.0;  // 1 / mm
  double most = 0.0;   // 1 / mm
};
// Of the corners, narrowed down by the plane where that is clear.
DepthRange range_of(const SeenFace& seen, const SeenPlane& plane);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of a mesh as the raster of a tile draws them: three edge functions and the inverse depth, all affine
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
#include <cstddef>
#include <cstdint>
#include <span>

#include "table/fill/cube_view.hpp"

namespace impinge {

inline constexpr double kMostTerms = 8.0;  // see above
inline constexpr double kMostThin =
    4096.0;  // largest sum of |terms| of the area over |area| with certain gradient and side

/// e above, cells.
constexpr double place_error(std::size_t divisions) { return 0x1p-49 * static_cast<double>(divisions); }

/// Faces on the grid of a face of the cube, their corners known; number by number, so that a vector holds
/// several of them.
struct CornerBatch {
  static constexpr std::size_t kMost = 64;    // faces: one bit each in 64
  using Numbers = std::array<double, kMost>;  // one a face

  alignas(64) std::array<Numbers, 3> x{};  // of each corner, cells
  alignas(64) std::array<Numbers, 3> y{};
  alignas(64) std::array<Numbers, 3> q{};    // 1 / mm
  std::array<std::uint32_t, kMost> faces{};  // of the mesh
  std::size_t count = 0;                     // of the faces
};

/// The same faces, ready to be drawn into a tile.
struct TileTriangles {
  using Numbers = std::array<float, CornerBatch::kMost>;        // one a face
  using Places = std::array<std::int32_t, CornerBatch::kMost>;  // one a face

  alignas(64) std::array<Numbers, 3> edge{};    // at the first entry; above zero inside
  alignas(64) std::array<Numbers, 3> edge_x{};  // from a column to the next
  alignas(64) std::array<Numbers, 3> edge_y{};  // from a row to the next
  alignas(64) Numbers q{};                      // 1 / mm, at the first entry
  alignas(64) Numbers q_x{};                    // from a column to the next
  alignas(64) Numbers q_y{};                    // from a row to the next
  alignas(64) Numbers doubt{};                  // of an edge function, see above
  alignas(64) Places first_column{};            // of the window, in the tile
  alignas(64) Places first_row{};
  alignas(64) Places columns{};  // of the window
  alignas(64) Places rows{};
  std::span<const std::uint32_t> faces;  // of the mesh
  std::uint64_t seen = 0;                // bit k: the window of face k holds an entry
  std::uint64_t clear = 0;               // of those that are seen; the others are drawn in double
};

/// `corners` of faces as the tile sees them, of a cube map with so many cells along an edge. Bit for
/// bit the same on every instruction set; numbers of faces that are not seen or not clear mean nothing.
void set_up(const CornerBatch& corners, const CubeTile& tile, std::size_t divisions, TileTriangles& drawn);

/// The inverse depth over the plane of a face: q + q_x (x - x_0) + q_y (y - y_0), from corner 0 on.
struct SeenPlane {
  double q_x = 0.0;    // 1 / mm a column
  double q_y = 0.0;    // 1 / mm a row
  double side = 0.0;   // +1 or -1: which way the corners go round, on the grid
  bool clear = false;  // are all these certain?
};
SeenPlane plane_of(const SeenFace& seen, std::size_t divisions);  // of a face whose corners are known

/// orientation() of the corners of a face, all of them through the same face of the cube that is in front of
/// them; 0 where the grid does not tell for certain.
std::int8_t side_of(const std::array<const SeenCorner*, 3>& corners, std::size_t divisions);

/// The part of the window within the tile; empty where there is none.
GridWindow window_in(const CubeTile& tile, const GridWindow& window);

/// Least and largest inverse depth of a face in its window, 1 / mm, from outside.
struct DepthRange {
  double least = 0.0;  // 1 / mm
  double most = 0.0;   // 1 / mm
};
/// Of the corners, narrowed down by the plane where that is clear.
DepthRange range_of(const SeenFace& seen, const SeenPlane& plane);

}  // namespace impinge

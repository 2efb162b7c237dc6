// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing faces into a tile of a cube map with vector instructions; bit for bit the same on every
// instruction set.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "table/fill/tile_triangle.hpp"
#include "table/layer.hpp"

namespace impinge {

/// The inverse depths of a tile while it is drawn, row by row.
struct TileCanvas {
  /// Vectors may reach beyond the last column that is seen.
  static constexpr std::size_t kStride = CubeTiling::kMostSeen + 16;
  static constexpr std::size_t kRows = CubeTiling::kMostSeen;  // that a tile sees at most

  alignas(64) std::array<float, kStride * kRows> q;  // 1 / mm; no_depth() where nothing is drawn yet
};

/// What an entry without a surface holds: every drawn number replaces it. The nearest layer keeps the largest
/// inverse depth, the farthest the least.
float no_depth(Layer layer);

/// Decides exactly whether a face covers an entry of the tile.
struct ExactTest {
  /// Does face `face` cover the entry at that place of the tile?
  bool (*covers)(void* context, std::uint32_t face, std::size_t column, std::size_t row);
  void* context;  // handed to `covers`
};

/// Draws the clear triangles into the canvas, which keeps the right layer of each entry.
void draw(const TileTriangles& triangles, Layer layer, const ExactTest& exact, TileCanvas& canvas);

}  // namespace impinge

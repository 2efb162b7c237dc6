// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces of a mesh may be seen in which tile of a cube map.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "table/fill/tile_triangle.hpp"

namespace impinge {

/// Faces by tile.
struct TileBins {
  std::vector<std::uint32_t> faces;  // those of a tile next to each other
  std::vector<std::size_t> first;    // of each tile, and one more
  std::vector<std::int8_t> sides;    // of all faces: orientation(), or 0 for those that are not known
  DepthRange range;                  // of all inverse depths that may be seen, 1 / mm; zeros for none

  /// The faces that may be seen in that tile, each once.
  std::span<const std::uint32_t> operator[](std::size_t tile) const {
    return std::span(faces).subspan(first[tile], first[tile + 1] - first[tile]);
  }
};

/// What the view sees of its faces; its corners have been seen.
TileBins tile_bins(const CubeView& view, const CubeTiling& tiling, std::size_t threads);

}  // namespace impinge

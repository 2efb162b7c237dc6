// SPDX-License-Identifier: GPL-3.0-or-later
// Lower bounds on the radii of a surface in and about a direction: all that is nearer to the centre is clear
// of the surface, by Theorem 9 (near). This holds for the narrowest gap, while the cells of
// contact/near_cells.hpp are wider than the gap of a joint.
//
// A direction is a point of the unit sphere and lies in a cell of a grid over the cube round it, which has no
// poles and no borders. A level has half as many cells along an axis as the one before.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "contact/face_runs.hpp"

namespace impinge {

struct LeastRadii {
  static constexpr std::int32_t kFinest = 64;  // cells of the first level along the cube's edge, of length 2
  static constexpr std::int32_t kLevels = 5;

  explicit LeastRadii(const FaceRuns& surface);

  /// Place of the first cell of each level, x running fastest, and at last of a 0 after all cells.
  std::array<std::uint32_t, kLevels + 1> first{};
  /// Square of a radius for each cell, mm^2. A point of the surface whose direction is, along each axis, at
  /// most one cell away from a direction in the cell is not nearer to the centre.
  std::vector<float> square;
};

}  // namespace impinge

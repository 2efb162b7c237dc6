// SPDX-License-Identifier: GPL-3.0-or-later
// How near to the centre does a surface come, at most, in and about a direction? What a ball has within that
// is clear of it, whatever the gap: the cells of contact/near_cells.hpp are wider than that of a joint.
//
// A direction is a point of the unit sphere, and that lies in a cell of a grid over its cube: no poles, no
// borders. A level has half as many cells along an axis as the one before. Theorem 9 (near).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "contact/face_runs.hpp"

namespace impinge {

struct LeastRadii {
  static constexpr std::int32_t kFinest = 64;  // cells of the first level, along the cube's edge of length 2
  static constexpr std::int32_t kLevels = 5;

  explicit LeastRadii(const FaceRuns& surface);

  /// Place of the first cell of each level, x fastest; and of a 0 after all.
  std::array<std::uint32_t, kLevels + 1> first{};
  /// mm^2, of a cell: no point of the surface is nearer to the centre whose direction is, along each axis, at
  /// most a cell away from some direction in it.
  std::vector<float> square;
};

}  // namespace impinge

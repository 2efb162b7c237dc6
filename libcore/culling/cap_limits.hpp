// SPDX-License-Identifier: GPL-3.0-or-later
// How near to the centre a surface comes, or how far from it, over a cap of directions of any size: one
// look-up.
//
// A ladder of gnomonic cube grids, n = 2, 4, 8 ... cells along an edge. Each entry holds the limit of all
// faces that have a direction within c + reach + margin of it, c = sqrt(2) / n being the farthest that a
// direction is from the entry nearest to it on the grid (that way is along a straight line of the gnomonic
// plane, and central projection makes no length longer), reach = 4 / n. So
//
//   within(x, angle), angle <= reach: no face has a smaller radius (a larger one for Layer::farthest) in any
//   direction within `angle` of x, nor within the margin of such a direction
//
// The finest grid is there once more with a reach of 0, for single vertices. A table whose look-ups read
// entries within the margin, and answer with a mean of them, keeps the limits too.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "culling/cap_tree.hpp"
#include "culling/cube_place.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sampling/layer.hpp"
#include "sphere/infinity.hpp"

namespace impinge {

class CapLimits {
 public:
  // mesh in the centre frame; margin in radians. O(faces). Faces whose plane holds the centre cover no
  // direction and are left out.
  CapLimits(const TriangleMesh& mesh, Layer layer, double margin = 0.0);

  struct Limit {
    double radius;  // mm; infinite for the nearest, and -1 for the farthest, where there is no surface
    double reach;   // radians: it holds for caps as wide as that
  };
  // angle of 0 or more.
  Limit within(const Vec3& x, double angle) const {
    // 2^e <= angle < 2^(e + 1), e from the bits of a float: the level whose reach is 2^(e + 1).
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(angle));
    const int level = 1 - (static_cast<int>(bits >> 23U) - 127);
    if (level < 1) return {overall_, kInfinity};
    return at(levels_[std::min(static_cast<std::size_t>(level), levels_.size() - 1)], x);
  }
  // In the direction of x.
  double beside(const Vec3& x) const { return at(single_, x).radius; }

  std::size_t bytes() const;

 private:
  struct Level {
    std::size_t cells = 1;
    double reach = kInfinity;
    std::vector<float> limits;
  };

  Limit at(const Level& level, const Vec3& x) const {
    const CubePlace place = cube_place(x);
    if (!(place.depth > 0.0)) return {overall_, kInfinity};
    const double half = 0.5 * static_cast<double>(level.cells);
    const auto column = static_cast<std::size_t>((place.a + 1.0) * half + 0.5);
    const auto row = static_cast<std::size_t>((place.b + 1.0) * half + 0.5);
    const std::size_t side = level.cells + 1;
    return {level.limits[(place.face * side + row) * side + column], level.reach};
  }
  double overall_;
  std::vector<Level> levels_;  // the first is not used: all directions
  Level single_;
};

}  // namespace impinge

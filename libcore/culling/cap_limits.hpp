// SPDX-License-Identifier: GPL-3.0-or-later
// How near to the centre a surface comes, or how far from it, over a cap of directions of any size: one
// look-up.
//
// A ladder of gnomonic cube grids of n cells along an edge. Each entry holds the limit of all faces that have
// a direction within c + reach + margin of it, c = sqrt(2) / n being the farthest that a direction is from
// the entry nearest to it on the grid (that way is along a straight line of the gnomonic plane, and central
// projection makes no length longer); the reaches are 2, 1.5, 1, 0.75, 0.5 ... radians. So
//
//   within(x, angle), angle <= reach: no face has a smaller radius (a larger one for Layer::farthest) in any
//   direction within `angle` of x, nor within the margin of such a direction
//
// There is one grid more with a reach of 0, for single vertices. A table whose look-ups read
// entries within the margin, and answer with a mean of them, keeps the limits too.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "culling/cap_tree.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sampling/layer.hpp"

namespace impinge {

class CapLimits {
 public:
  // mesh in the centre frame; margin in radians. O(faces). Faces whose plane holds the centre cover no
  // direction and are left out.
  CapLimits(const TriangleMesh& mesh, Layer layer, double margin = 0.0);

  // The limit of a cap.
  struct Limit {
    float radius;  // mm; where there is no surface infinite for the nearest, -infinite for the farthest
    float reach;   // radians: it holds for caps as wide as that
  };
  // The limit of all directions within `angle` radians of x, see above. angle of 0 or more; NaN, like
  // infinity, is any angle. x of any length; it may be 0 where any angle is, and only then.
  Limit within(const Eigen::Vector3f& x, float angle) const {
    // The exponent of a float and half of its octave, which a reach ends.
    const int level = kWidest - static_cast<int>(std::bit_cast<std::uint32_t>(angle) >> kHalfOctave);
    const Level& at = levels_[static_cast<std::size_t>(std::clamp(level, 0, finest_))];
    return {look_up(at, x), at.reach};
  }
  float overall() const { return overall_; }  // of all directions
  // In the direction of x.
  float beside(const Vec3& x) const { return x.isZero(0.0) ? overall_ : look_up(single_, x.cast<float>()); }

  std::size_t bytes() const;  // of memory

 private:
  static constexpr unsigned kHalfOctave = 22;                                        // bits
  static constexpr int kWidest = std::bit_cast<std::uint32_t>(2.0F) >> kHalfOctave;  // of the widest reach

  struct Level {
    std::uint32_t cells = 1;
    float reach = HUGE_VALF;
    std::vector<float> limits;
  };

  // At the entry nearest to x, without a branch on where that is; see cube_place.hpp.
  float look_up(const Level& level, const Eigen::Vector3f& x) const {
    const Eigen::Array3f size = x.array().abs();
    const unsigned on_x =
        static_cast<unsigned>(size[0] >= size[1]) & static_cast<unsigned>(size[0] >= size[2]);
    const unsigned axis = (1U - on_x) * (1U + static_cast<unsigned>(size[1] < size[2]));
    const float depth = std::max(size.maxCoeff(), std::numeric_limits<float>::min());
    const float cells = static_cast<float>(level.cells);
    const float half = 0.5F * cells / depth;
    const float middle = 0.5F * cells + 0.5F;
    const auto column = static_cast<std::uint32_t>(x[axis == 0 ? 1 : 0] * half + middle);
    const auto row = static_cast<std::uint32_t>(x[axis == 2 ? 1 : 2] * half + middle);
    const std::uint32_t face = 2 * axis + static_cast<unsigned>(x[axis] < 0.0F);
    const std::uint32_t side = level.cells + 1;
    return level.limits[(face * side + row) * side + column];
  }

  float overall_;
  std::vector<Level> levels_;  // the first is of all directions
  int finest_ = 0;
  Level single_;
};

}  // namespace impinge

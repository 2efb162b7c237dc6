// SPDX-License-Identifier: GPL-3.0-or-later
// How near to the centre a surface comes, or how far from it, over a cap of directions of any size: one
// look-up.
//
// A level is a gnomonic cube grid of n cells along an edge. Each entry holds the limit of all faces that have
// a direction within c + reach of it, c = sqrt(2) / n being the farthest that a direction is from
// the entry nearest to it on the grid (that way is along a straight line of the gnomonic plane, and central
// projection makes no length longer); the reaches are 2, 1.75, 1.5, 1.25, 1, 0.875 ... radians. So
//
//   within(x, angle), angle <= reach: no face has a smaller radius (a larger one for Layer::farthest) in any
//   direction within `angle` of x
//
// There is one grid more, finer, with a reach of kAloneReach, for single vertices.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "table/layer.hpp"

namespace impinge {

/// The grids of all levels, as kernels read them.
struct CapLevels {
  const std::int32_t* steps;  // of each level: cells along an edge in the lowest kLineBits, and above them
                              // the place of its first limit, unsigned
  const float* limits;        // of each level by face, row and column, mm
  std::int32_t finest;        // level of caps; the next one is that of single vertices
};

class CapLimits {
 public:
  static constexpr int kQuarterOctave = 21;  // bits of a float below a quarter of its octave
  /// Exponent and two bits of the widest reach, 2 radians.
  static constexpr std::int32_t kWidest = std::bit_cast<std::uint32_t>(2.0F) >> kQuarterOctave;
  static constexpr float kAloneReach = 1e-4F;  // radians, of single vertices
  static constexpr int kLineBits = 9;          // bits of a step that hold the cells along an edge
  static constexpr std::int32_t kMostLines = (1 << kLineBits) - 1;  // most cells along an edge

  /// mesh in the centre frame, mm. O(faces). Faces whose plane holds the centre cover no
  /// direction and are left out.
  CapLimits(const TriangleMesh& mesh, Layer layer);

  /// The limit of all directions within `angle` radians of x, mm, see above; where there is no surface
  /// infinite for the nearest, -infinite for the farthest. angle of 0 or more; NaN, like infinity, means any
  /// angle. x of any length; it may be 0 only with such an angle.
  float within(const Vec3& x, float angle) const {
    const int level = kWidest - static_cast<int>(std::bit_cast<std::uint32_t>(angle) >> kQuarterOctave);
    return look_up(std::clamp(level, 0, finest_), x);
  }
  /// The grids as kernels read them; borrowed from this.
  CapLevels levels() const { return {steps_.data(), limits_.data(), finest_}; }

  std::size_t bytes() const;  // of memory

 private:
  /// At the entry nearest to x; see sphere/cube_faces.hpp.
  float look_up(int level, const Vec3& x) const;
  float reach(int level) const;

  std::vector<std::int32_t> steps_;
  std::vector<float> limits_;
  std::int32_t finest_ = 0;
};

}  // namespace impinge

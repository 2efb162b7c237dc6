// SPDX-License-Identifier: GPL-3.0-or-later
// Tells with one look-up how near to the centre a surface comes, or how far from it, over a cap of directions
// of any size.
//
// A level is a gnomonic cube grid of n cells along an edge. Each entry holds the limit of all faces that have
// a direction within c + reach of it, where c = sqrt(2) / n: no direction is farther from its nearest entry,
// as central projection makes no length longer. The reaches are 2, 1.75, 1.5, 1.25, 1, 0.875 ... radians. So
// within(x, angle) of a level with angle <= reach bounds the radii of all faces in all directions within
// `angle` of x. One more grid, a finer one with a reach of kAloneReach, is for single vertices.
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

/// The grids of all levels, in the form that kernels read.
struct CapLevels {
  const std::int32_t* steps;  // of each level: cells along an edge in the lowest kLineBits, and above them
                              // the place of its first limit, unsigned
  const float* limits;        // of each level by face, row and column, mm
  std::int32_t finest;        // the finest level for caps; the next one is for single vertices
};

class CapLimits {
 public:
  static constexpr int kQuarterOctave = 21;  // a float without so many bits is in steps of a quarter octave
  /// Exponent and two bits of the widest reach, 2 radians.
  static constexpr std::int32_t kWidest = std::bit_cast<std::uint32_t>(2.0F) >> kQuarterOctave;
  static constexpr float kAloneReach = 1e-4F;  // radians, for single vertices
  static constexpr int kLineBits = 9;          // bits of a step that hold the cells along an edge
  static constexpr std::int32_t kMostLines = (1 << kLineBits) - 1;  // most cells along an edge

  /// Makes the grids of `mesh`, which is in the centre frame, mm, in O(faces). Faces whose plane holds the
  /// centre cover no direction and are left out.
  CapLimits(const TriangleMesh& mesh, Layer layer);

  /// The limit of all directions within `angle` radians of x, mm: no face has a smaller radius there (a
  /// larger one for Layer::farthest). If there is no surface, infinite for the nearest layer, -infinite for
  /// the farthest. `angle` is 0 or more; NaN or infinity means all directions, and only then may x be 0.
  float within(const Vec3& x, float angle) const {
    const int level = kWidest - static_cast<int>(std::bit_cast<std::uint32_t>(angle) >> kQuarterOctave);
    return look_up(std::clamp(level, 0, finest_), x);
  }
  /// The grids in the form that kernels read; they borrow memory from this.
  CapLevels levels() const { return {steps_.data(), limits_.data(), finest_}; }

  std::size_t bytes() const;  // of memory

 private:
  /// The limit of a level at the entry nearest to x; see sphere/cube_faces.hpp.
  float look_up(int level, const Vec3& x) const;
  float reach(int level) const;

  std::vector<std::int32_t> steps_;
  std::vector<float> limits_;
  std::int32_t finest_ = 0;
};

}  // namespace impinge

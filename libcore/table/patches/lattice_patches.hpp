// SPDX-License-Identifier: GPL-3.0-or-later
// Patches of the Fibonacci lattice: its Delaunay triangles, found by walking from each across its sides. On a
// triangle the interpolation is linear in the point of the flat triangle along the direction.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "sphere/schemes/fibonacci.hpp"
#include "table/patches/patch.hpp"
#include "table/patches/solid_patches.hpp"

namespace impinge {

class LatticePatches {
 public:
  /// Finds all triangles. Throws std::logic_error if they do not close round the sphere.
  explicit LatticePatches(const Fibonacci& scheme) : scheme_(scheme), seen_(scheme.cells(), false) {
    find_from(scheme_.stencil(scheme_.direction(0) + scheme_.direction(1)));
    for (std::size_t k = 0; k < triangles_.size(); ++k) cross_sides(Triangle(triangles_[k]));
    // By Euler's formula a closed surface of triangles with N corners has 2 N - 4 of them.
    if (triangles_.size() + 4 != 2 * scheme_.size()) {
      throw std::logic_error("the triangles of a Fibonacci lattice do not close round the sphere");
    }
  }

  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t k = 0; k < triangles_.size(); ++k) visit(Patch{k, {{0.0, 0.0}, {1.0, 1.0}}});
  }

  Vec3 at(const Patch& patch, double s, double t) const {
    const auto& [p, q, r] = triangles_[patch.part];
    const Vec3 from = scheme_.direction(p);
    return from + s * ((1.0 - t) * (scheme_.direction(q) - from) + t * (scheme_.direction(r) - from));
  }

  PatchMotion motion(const Patch& patch, const Rect& rect) const {
    return projected_motion({{at(patch, rect.from[0], rect.from[1]), at(patch, rect.to[0], rect.from[1]),
                              at(patch, rect.from[0], rect.to[1]), at(patch, rect.to[0], rect.to[1])},
                             {}});
  }

 private:
  using Triangle = std::array<std::size_t, 3>;

  void find_from(const Stencil& stencil) {
    if (seen_[stencil.cell]) return;
    seen_[stencil.cell] = true;
    triangles_.push_back({stencil.entry[0], stencil.entry[1], stencil.entry[2]});
  }

  /// Looks up the triangle across each side, at a direction a little beyond the middle of the side.
  void cross_sides(const Triangle& triangle) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = scheme_.direction(triangle[k]);
      const Vec3 b = scheme_.direction(triangle[(k + 1) % 3]);
      const Vec3 c = scheme_.direction(triangle[(k + 2) % 3]);
      const Vec3 middle = 0.5 * (a + b);
      find_from(scheme_.stencil(middle + kBeyond * (middle - c)));
    }
  }

  static constexpr double kBeyond = 1e-4;  // of the height of a triangle

  Fibonacci scheme_;
  std::vector<bool> seen_;
  std::vector<Triangle> triangles_;
};

inline LatticePatches patches_of(const Fibonacci& scheme) { return LatticePatches(scheme); }

}  // namespace impinge

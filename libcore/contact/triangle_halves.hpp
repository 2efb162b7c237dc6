// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "mesh/triangle_distance.hpp"

namespace impinge {

/// A triangle cut in two from the middle of its longest side.
inline std::array<Triangle, 2> halves(const Triangle& of) {
  std::size_t longest = 0;
  const auto squared = [&](std::size_t k) { return (of[(k + 1) % 3] - of[k]).squaredNorm(); };
  for (std::size_t k = 1; k < 3; ++k) longest = squared(k) > squared(longest) ? k : longest;
  const Vec3& a = of[longest];
  const Vec3& b = of[(longest + 1) % 3];
  const Vec3& c = of[(longest + 2) % 3];
  const Vec3 middle = 0.5 * (a + b);
  return {Triangle{a, middle, c}, Triangle{middle, b, c}};
}

}  // namespace impinge

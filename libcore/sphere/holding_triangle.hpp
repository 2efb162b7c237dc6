// SPDX-License-Identifier: GPL-3.0-or-later
// The spherical Delaunay triangle that holds a direction, among given entries.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "sphere/direction.hpp"

namespace impinge {

/// Places of three entries in the given span, and weights that are not negative and sum to 1.
struct HoldingTriangle {
  std::array<std::size_t, 3> place{};  // of its corners in the span
  std::array<double, 3> weight{};      // of the corners, in the same order
};

/// Delaunay triangles are the faces of the convex hull, and the ray along unit u leaves the hull through the
/// one whose lambda in sum lambda_j p_j = u, lambda >= 0, has the smallest sum: the simplex method, a few
/// steps for the tens of entries round u. The weights are lambda / sum lambda.
HoldingTriangle holding_triangle(std::span<const Vec3> entries, const Vec3& u);

}  // namespace impinge

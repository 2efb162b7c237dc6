// SPDX-License-Identifier: GPL-3.0-or-later
// Finds, among given entries, the spherical Delaunay triangle that holds a direction.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "sphere/direction.hpp"

namespace impinge {

/// A triangle of three of the entries, and weights that are not negative and sum to 1.
struct HoldingTriangle {
  std::array<std::size_t, 3> place{};  // index of each corner in the span of entries
  std::array<double, 3> weight{};      // of the corners, in the same order
};

/// The triangle that holds the unit vector u. Delaunay triangles are the faces of the convex hull of the
/// entries p_j. The ray along u leaves the hull through the face with the smallest sum of lambda >= 0 in sum
/// lambda_j p_j = u, which the simplex method finds in a few steps for the tens of entries round u. The
/// weights are lambda / sum lambda.
HoldingTriangle holding_triangle(std::span<const Vec3> entries, const Vec3& u);

}  // namespace impinge

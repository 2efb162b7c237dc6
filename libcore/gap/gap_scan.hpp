// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A scan of Algorithm 2: all vertices of one surface against the other, with one signed gap for both
/// (gap/surface.hpp).
///
/// The thesis' test `d <= d_i` is right for ball vertices against the socket's table and wrong the other way
/// round, and it keeps the distance of colliding vertices only. Here every vertex of both scans gets its
/// signed gap. kNoSurface (NaN) where the other surface is not met: no surface there is never a hit.
#pragma once

#include <cassert>
#include <concepts>
#include <cstddef>
#include <span>

#include "gap/surface.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {

/// Anything that gives the radius of a surface along x, of any length above zero: a table, its faces. mm,
/// kNoSurface where it has no answer.
template <class Q>
concept RadialQuery = requires(const Q& query, const Vec3& x) {
  { query.radius_at(x) } -> std::convertible_to<double>;
};

/// Gaps of `vertices` (mm, in the centre frame of their surface `of`) to the other surface, which `query`
/// answers for. gap has the size of the vertices, mm.
template <RadialQuery Query>
void scan_gaps(const Query& query, std::span<const Vec3> vertices, const Pose& pose, Surface of,
               std::span<double> gap) {
  assert(gap.size() == vertices.size());
  for (std::size_t i = 0; i < gap.size(); ++i) {
    const Vec3 x = to_other(of, pose, vertices[i]);
    gap[i] = signed_gap(of, query.radius_at(x), x.norm());
  }
}

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A scan of the thesis' Algorithm 2: the signed gap (gap/surface.hpp) of every vertex of one surface to the
/// other surface. The gap is kNoSurface (NaN) where the other surface is not met, which never counts as a
/// hit.
///
/// The thesis' test `d <= d_i` is right for vertices of the ball against the socket's table, wrong the other
/// way round, and keeps the distances of colliding vertices only.
#pragma once

#include <cassert>
#include <concepts>
#include <cstddef>
#include <span>

#include "gap/surface.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {

/// Anything that gives the radius of a surface along x (any length above zero), such as a table or its faces:
/// radius_at(x), mm, or kNoSurface.
template <class Q>
concept RadialQuery = requires(const Q& query, const Vec3& x) {
  { query.radius_at(x) } -> std::convertible_to<double>;
};

/// Writes to `gap` the gaps of `vertices` to the other surface, mm. `query` answers for the other surface.
/// Vertices are in mm in the centre frame of their surface `of`; `gap` has their size.
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

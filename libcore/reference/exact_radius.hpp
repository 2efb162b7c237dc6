// SPDX-License-Identifier: GPL-3.0-or-later
// The reference of every radial error: distance from the centre to a mesh along a direction, exact but for
// one rounding.
//
// The ray { t u, t > 0 } meets the face (v0, v1, v2) with normal n = (v1 - v0) x (v2 - v0) at
//   t = n.v0 / (n.u),   r = t |u| = root(((n.v0)^2 u.u) / (n.u)^2).
// A direction is three doubles and seldom of length 1 exactly, which r allows for. Which faces the ray meets
// is decided by CGAL's exact predicates, which of them is kept by comparing ratios of integers, and the root
// of the ratio is rounded once: each radius is the double nearest to the true one (an error of at most
// kExactRadiusError of it). Nothing is shared with the rasterisers and the ray caster that it judges.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "table/layer.hpp"

namespace impinge {

/// Relative error of a radius or distance of the reference: half a unit in the last place.
inline constexpr double kExactRadiusError = 0x1p-53;

/// The directions along which the radius is asked for.
struct RadiusQuery {
  std::span<const Vec3> directions;                // of any length above zero
  Layer layer = Layer::nearest;                    // which crossing counts
  std::function<void(std::size_t)> progress = {};  // called at times with the number of directions done
};

/// Radius along each direction, mm; kNoSurface where no face is met. mesh in the centre frame. Boundaries
/// belong to faces. Faces whose plane holds the centre, exactly, cover no direction and are left out. Throws
/// std::invalid_argument as require_exact_input(), and for a direction that is zero or not finite. About 7
/// microseconds a direction of 12,000 faces.
std::vector<double> exact_radii(const TriangleMesh& mesh, const RadiusQuery& query);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// The Delaunay triangulation of directions on the sphere, by CGAL with exact predicates; no header of CGAL is
// needed to use it.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "sphere/direction.hpp"

namespace impinge {

/// Places of three directions, counter-clockwise as seen from outside.
using SphereTriangle = std::array<std::size_t, 3>;

/// Triangles whose circles hold no other direction inside: 2 n - 4 for n directions, which are taken as rays,
/// so that the rounding of their lengths does not count. Where four or more lie on one circle any of their
/// triangulations is right, and one is chosen. Throws std::invalid_argument for fewer than four directions,
/// for directions that all lie in one hemisphere, two that are the same, and one that is zero or not finite.
std::vector<SphereTriangle> delaunay_triangles(std::span<const Vec3> directions);

}  // namespace impinge

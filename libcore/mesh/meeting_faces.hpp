// SPDX-License-Identifier: GPL-3.0-or-later
// Decides by exact signs (sphere/plane_side.hpp) whether two triangles have a common point: they have one if
// a side of one meets the other.
#pragma once

#include "mesh/triangle_distance.hpp"

namespace impinge {

/// Do the segment p - q and the triangle meet, ends and sides included? A triangle without area meets
/// nothing.
bool meets_segment(const Triangle& face, const Vec3& p, const Vec3& q);

/// Do two triangles meet, sides and corners included? Both must have an area.
bool faces_meet(const Triangle& a, const Triangle& b);

}  // namespace impinge

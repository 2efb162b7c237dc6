// SPDX-License-Identifier: GPL-3.0-or-later
// Where a surface crosses a plane through the origin.
#pragma once

#include <vector>

#include "mesh/sphere_section.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// One segment for each face with corners on both sides of the plane n.x = 0, between the points where two of
// its edges cross it. `normal` has any length above 0. A corner on the plane counts as in front (n.x > 0), so
// that neighbouring faces cross at the same points and the section of a closed body is closed; a face that
// only touches the plane with such a corner gives a segment of no length.
std::vector<Segment> plane_section(const TriangleMesh& mesh, const Vec3& normal);

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// Where a surface crosses a sphere about the origin.
#pragma once

#include <array>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

using Segment = std::array<Vec3, 2>;  // its two ends, mm

/// One segment for each face with corners on both sides of the sphere (mm), between the points where two of
/// its edges cross it; a corner on the sphere counts as outside. Every end lies on an edge, at the radius up
/// to rounding: an edge crosses the sphere once if its ends lie on both sides. A corner that pokes through
/// within a face is not seen.
std::vector<Segment> sphere_section(const TriangleMesh& mesh, double radius);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Finds where a surface crosses a sphere about the origin.
#pragma once

#include <array>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

using Segment = std::array<Vec3, 2>;  // its two ends, mm

/// One segment for each face with corners on both sides of the sphere of this radius (mm): between the points
/// where two of its edges cross the sphere, which are at the radius up to rounding. A corner on the sphere
/// counts as outside. A face that crosses the sphere with all corners on one side is missed.
std::vector<Segment> sphere_section(const TriangleMesh& mesh, double radius);

}  // namespace impinge

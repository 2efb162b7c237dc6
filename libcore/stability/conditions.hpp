// SPDX-License-Identifier: GPL-3.0-or-later
// How much of its digits a radius may lose.
//
// Along the plane n . x = p the radius is r = p / (n . u), and d ln r / d angle = tan psi, psi the angle from
// u to the normal: a rounding of the direction costs 1 + tan psi. A rounding of (b - a) x (c - a) tilts the
// plane by that over the sine of the angle at a, and costs
//   R |b - a| |c - a| / (n . a),   R the farthest corner,
// the more the thinner the face and the more oblique. The condition is the larger of both, at an edge or
// vertex the largest of the faces that meet there.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

struct RayCondition {
  double slope = 0.0;  // tan psi of the nearest face
  double tilt = 0.0;   // of its plane, see above
  double condition() const { return std::max(1.0 + slope, tilt); }
};

// Of the nearest face along each direction, 0 where there is none. mesh in the centre frame. In extended
// precision, and with none of the library's own planes.
std::vector<RayCondition> conditions_along(const TriangleMesh& mesh, std::span<const Vec3> directions);

// Largest tan psi over the median one, each face seen along its centroid. 1 for a sphere about the centre at
// most; above 1000 a scene is stiff.
double stiffness(const TriangleMesh& mesh);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// How much of its digits a radius may lose.
//
// Along the plane n . x = p the radius is r = p / (n . u), and d ln r / d angle = tan psi, psi the angle from
// u to the normal: a rounding of the direction costs 1 + tan psi. That is the condition, at an edge or vertex
// the largest of the faces that meet there. How thin a face is does not count: its plane is as certain as its
// corners are (sphere/face_plane.hpp).
#pragma once

#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// How steep the surface is along one direction.
struct RayCondition {
  double slope = 0.0;                               // tan psi of the nearest face
  double condition() const { return 1.0 + slope; }  // relative error of the radius for one of the direction
};

// Of the nearest face along each direction, 0 where there is none. mesh in the centre frame. In extended
// precision, and with none of the library's own planes.
std::vector<RayCondition> conditions_along(const TriangleMesh& mesh, std::span<const Vec3> directions);

// Largest tan psi over the median one, each face seen along its centroid. 1 for a sphere about the centre at
// most; above 1000 a scene is stiff.
double stiffness(const TriangleMesh& mesh);

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of revolution for the phantoms: rings of vertices about an axis.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// A ring of vertices: `radius` mm from the origin, `polar` radians from the axis. At 0 and pi it is a pole.
struct LatheRing {
  double polar = 0.0;   // radians
  double radius = 0.0;  // mm
};

/// Rings from one pole, about a unit axis through `centre`, `sides` vertices each; closed if the last is a
/// pole.
struct Revolution {
  std::vector<LatheRing> rings;  // in order from the first pole
  Vec3 axis = Vec3::UnitZ();     // unit vector, towards the first pole
  Vec3 centre = Vec3::Zero();    // mm
  std::size_t sides = 360;       // vertices of a ring
};
TriangleMesh revolve(const Revolution& body);  // its mesh, normals outward

/// Rings of a sphere of `radius` mm from the axis to `to` radians, `step` radians apart.
std::vector<LatheRing> sphere_rings(double radius, double to, double step);

/// Rings of a whole sphere of `radius` mm about the axis, closer together towards it: each is 1.15 times as
/// far from the axis as the one before.
std::vector<LatheRing> focused_rings(double radius);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Bone beside a generated joint that can stop its motion: trochanters and the anterior inferior iliac spine,
// as ellipsoids. Joint frame of a right hip, the centre of the head as origin, mm.
#pragma once

#include <string>
#include <vector>

#include "hip/hip_surface.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// An ellipsoid.
struct BonePart {
  std::string name;      // in words
  Vec3 middle;           // mm
  Eigen::Matrix3d axes;  // its half axes as columns, mm; of determinant above 0

  /// Distance at which a ray from the origin enters the ellipsoid, mm; NaN if it misses.
  double nearest(const Vec3& direction) const;
  double farthest(const Vec3& direction) const;  // distance at which it leaves; NaN likewise
};

/// The greater and the lesser trochanter, if the hip has them.
std::vector<BonePart> femur_parts(const HipSurface& hip);
/// The anterior inferior iliac spine, if the hip has one.
std::vector<BonePart> acetabulum_parts(const HipSurface& hip);

/// Closed, normals outward, vertices on the ellipsoid; edges are about `spacing` mm long, and there are no
/// more than 5120 faces.
TriangleMesh mesh_of(const BonePart& part, double spacing);

}  // namespace impinge

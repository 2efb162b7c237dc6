// SPDX-License-Identifier: GPL-3.0-or-later
// Bone beside a generated joint that can stop it: trochanters and the anterior inferior iliac spine, as
// ellipsoids. Joint frame, of a right hip, the centre of the head as origin, mm.
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

  /// Where a ray from the origin enters and leaves it, mm; NaN where it does not meet it.
  double nearest(const Vec3& direction) const;
  double farthest(const Vec3& direction) const;  // where it leaves it, see above
};

/// Greater and lesser trochanter, those that there are: they stand on the shaft.
std::vector<BonePart> femur_parts(const HipSurface& hip);
/// The spine, if there is one.
std::vector<BonePart> acetabulum_parts(const HipSurface& hip);

/// Closed, normals outward, vertices on the ellipsoid; edges are about `spacing` mm long, and there are no
/// more than 5120 faces.
TriangleMesh mesh_of(const BonePart& part, double spacing);

}  // namespace impinge

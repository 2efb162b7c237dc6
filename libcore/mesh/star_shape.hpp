// SPDX-License-Identifier: GPL-3.0-or-later
// Tells whether a surface is star-shaped about the centre, so that one radius in each direction describes it.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Whether a surface is star-shaped, and if not, what is in the way and how much of it.
struct StarShapeReport {
  /// True if all faces look to one side (n.v0 > 0, or all < 0 as in a socket) and no two faces overlap as
  /// seen from the centre. Both are decided by exact signs.
  bool star_shaped = false;
  std::size_t front_facing = 0;  // faces with n.v0 > 0, normals away from the centre
  std::size_t back_facing = 0;   // n.v0 < 0
  std::size_t edge_on = 0;       // n.v0 = 0: the plane of the face holds the centre
  /// Number of pairs of faces that share directions inside both, as seen from the centre; 0 if not counted,
  /// as where faces look to both sides.
  std::size_t overlapping_pairs = 0;
  /// Signed solid angle of all faces, steradians: 4 pi for a closed body round the centre, 0 for a closed
  /// body beside it.
  double solid_angle = 0.0;
  /// Shares of all directions, measured on a grid of `directions` with area weights.
  double covered = 0.0;        // of directions that meet the surface
  double violating = 0.0;      // of directions that meet it more than once
  std::size_t directions = 0;  // of the grid
};

/// The report on `mesh`, which is in the centre frame, with lengths as in mesh/lengths.hpp. O(faces +
/// directions) for faces of similar size.
StarShapeReport star_shape(const TriangleMesh& mesh);

/// Signed solid angle of a triangle seen from the origin, steradians in (-2 pi, 2 pi) (Van Oosterom and
/// Strackee 1983, "The solid angle of a plane triangle").
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c);

/// Do the cones over two triangles share directions inside both? Exact. Both must have a nonzero solid angle.
bool cones_overlap(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b);

/// The report as one line of text, without a line end.
std::string describe(const StarShapeReport& report);

}  // namespace impinge

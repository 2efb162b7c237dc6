// SPDX-License-Identifier: GPL-3.0-or-later
// Is a surface star-shaped about the centre, so that one radius a direction tells all of it?
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// What keeps a surface from being star-shaped, and how much of it.
struct StarShapeReport {
  /// Proven: all faces lie on one side (n.v0 > 0, or all < 0 as in a socket) and no two faces overlap as seen
  /// from the centre. Both are decided with exact signs.
  bool star_shaped = false;
  std::size_t front_facing = 0;  // faces with n.v0 > 0, normals away from the centre
  std::size_t back_facing = 0;   // n.v0 < 0
  std::size_t edge_on = 0;       // n.v0 = 0: the plane of the face holds the centre
  /// Pairs of faces that share directions inside both, as seen from the centre; 0 if not counted.
  std::size_t overlapping_pairs = 0;
  /// Signed solid angle of all faces, steradians: 4 pi for a closed body round the centre, 0 for one beside
  /// it.
  double solid_angle = 0.0;
  /// Shares of all directions, measured on a grid of `directions` with area weights.
  double covered = 0.0;        // meet the surface
  double violating = 0.0;      // meet it more than once
  std::size_t directions = 0;  // of the grid
};

/// mesh in the centre frame, with lengths as in mesh/lengths.hpp. O(faces + directions) for faces of similar
/// size.
StarShapeReport star_shape(const TriangleMesh& mesh);

/// Signed solid angle of a triangle seen from the origin, steradians in (-2 pi, 2 pi) (Van Oosterom and
/// Strackee 1983, "The solid angle of a plane triangle").
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c);

/// Do the cones over two triangles share directions inside both? Exact. Both must have a nonzero solid angle.
bool cones_overlap(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b);

/// The report as one line of text, without a line end.
std::string describe(const StarShapeReport& report);

}  // namespace impinge

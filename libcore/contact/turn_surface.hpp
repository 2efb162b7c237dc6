// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles as searches in a turn take them, and the walls that a threshold of the gap needs.
#pragma once

#include <array>
#include <vector>

#include "mesh/jump_edges.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// A triangle, or one half of a wall.
struct TurnFace {
  std::array<Vec3, 3> corner;  // mm
  Vec3 normal;                 // as long as twice the area
  double size = 0.0;           // mm^2, the product of the two longest sides; |normal| is no larger
  bool wall = false;           // of a wall, not of the surface
  bool thin = false;           // the direction of its normal is not certain (contact/part_distance.hpp)
  double doubt = 0.0;          // mm, by which rounding may have moved it, beyond the common tolerance
};

/// The triangle, mm; not of a wall.
TurnFace turn_face(const Vec3& a, const Vec3& b, const Vec3& c);
/// A point, mm: a triangle without extent.
TurnFace turn_point(const Vec3& x);
/// The faces of a mesh, mm.
std::vector<TurnFace> turn_faces(const TriangleMesh& mesh);
/// The same triangle or wall after a rotation.
TurnFace turned_by(const Eigen::Matrix3d& rotation, const TurnFace& face);

/// A side of a face, mm.
struct TurnEdge {
  Vec3 from;  // an end
  Vec3 to;    // the other end
};

/// What lies beyond the jump edges of a mesh in its centre frame, to a distance of `reach` from the centre at
/// least, mm: the ball reaches a socket that it gets beyond. A wall is cut in pieces that the centre sees
/// under 60 degrees at most, so that it is whole however near the edge comes to the centre.
std::vector<TurnFace> walls_beyond(const TriangleMesh& mesh, const std::vector<JumpEdge>& jumps,
                                   double reach);
/// What lies within them, to the centre: the socket reaches a ball that it gets within.
std::vector<TurnFace> walls_within(const TriangleMesh& mesh, const std::vector<JumpEdge>& jumps);

}  // namespace impinge

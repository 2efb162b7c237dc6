// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles of surfaces that a search in a turn uses, and the walls that a threshold of the gap needs.
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
  bool wall = false;           // part of a wall, not of the surface
  bool thin = false;           // the direction of its normal is not certain (contact/part_distance.hpp)
  double doubt = 0.0;          // mm; rounding may have moved it by so much beyond the common tolerance
};

/// A triangle of the surface, mm.
TurnFace turn_face(const Vec3& a, const Vec3& b, const Vec3& c);
/// A point, mm: a triangle without extent.
TurnFace turn_point(const Vec3& x);
/// The faces of a mesh, mm.
std::vector<TurnFace> turn_faces(const TriangleMesh& mesh);
/// The triangle after a rotation.
TurnFace turned_by(const Eigen::Matrix3d& rotation, const TurnFace& face);

/// A side of a face, mm.
struct TurnEdge {
  Vec3 from;  // an end
  Vec3 to;    // the other end
};

/// The walls beyond the jump edges of a mesh in its centre frame, up to a distance of at least `reach` from
/// the centre, mm: a ball that gets beyond the socket meets them. They are cut into pieces that the centre
/// sees under 60 degrees at most, so that they are complete however near an edge comes to the centre.
std::vector<TurnFace> walls_beyond(const TriangleMesh& mesh, const std::vector<JumpEdge>& jumps,
                                   double reach);
/// The walls within the jump edges, down to the centre: a socket that gets within the ball meets them.
std::vector<TurnFace> walls_within(const TriangleMesh& mesh, const std::vector<JumpEdge>& jumps);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// A surface as the search for contacts in a turn takes it: its parts in a frame whose +z is the axis.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh/edges.hpp"
#include "mesh/jump_edges.hpp"
#include "mesh/triangle_mesh.hpp"
#include "motion/turn_tree.hpp"

namespace impinge {

/// A triangle, or one half of a wall.
struct TurnFace {
  std::array<Vec3, 3> corner;  // mm
  Vec3 normal;                 // as long as twice the area
  double size = 0.0;           // mm^2, the product of the two longest sides; |normal| is no larger
  bool wall = false;           // of a wall, not of the surface
  bool thin = false;           // the direction of its normal is not certain (motion/part_distance.hpp)
  double doubt = 0.0;          // mm, by which rounding may have moved it, beyond the common tolerance
};

/// The triangle, mm; not of a wall.
TurnFace turn_face(const Vec3& a, const Vec3& b, const Vec3& c);
/// Those of a mesh, mm.
std::vector<TurnFace> turn_faces(const TriangleMesh& mesh);

/// A side of a face, mm.
struct TurnEdge {
  Vec3 from;  // an end
  Vec3 to;    // the other end
};

/// Which side of a jump edge its wall is on: the ball reaches a socket that it gets beyond, and the socket a
/// ball that it gets within.
enum class WallSide { beyond, within };

/// How the walls of a surface are built.
struct WallReach {
  WallSide side = WallSide::beyond;  // for a socket `beyond`, for a ball `within`
  double reach = 0.0;  // mm, beyond: to this distance from the centre at least; within: to the centre
};

/// What of a mesh stays the same whatever the axis.
struct TurnParts {
  /// mesh in its centre frame, mm. Jumps are found where walls are asked for.
  TurnParts(const TriangleMesh& mesh, bool walls);

  std::vector<VertexIndex> vertices;              // of faces
  std::vector<std::uint32_t> by_vertex;           // places in `vertices`, those of near vertices together
  std::vector<std::uint32_t> by_face;             // faces, near ones together
  std::vector<double> nearest;                    // mm, of each face: its least distance from the centre
  std::vector<std::array<bool, 3>> first_corner;  // of each face: is it the first face of this corner?
  std::vector<std::array<bool, 3>> first_side;    // the same of the side from each corner to the next
  std::vector<JumpEdge> jumps;                    // mesh/jump_edges.hpp
  std::vector<VertexIndex> rim_vertices;          // ends of the jump edges
};

/// All of a surface that may take part in a contact.
struct TurnSurface {
  /// mesh in the centre frame, mm, without edge-on faces, and its parts, both borrowed; the rotation takes
  /// its axis to +z. A wall beyond an edge is cut in pieces that the centre sees under 60 degrees at most, so
  /// that it is whole however near the edge comes to the centre.
  TurnSurface(const TriangleMesh& mesh, const TurnParts& parts, const Eigen::Matrix3d& rotation,
              const WallReach& walls);

  TurnFace face(std::size_t f) const;  // of the mesh
  TurnTree tree(double margin) const;  // over the faces, which it may miss by no more than that, mm

  const TriangleMesh* mesh;           // borrowed
  const TurnParts* parts;             // borrowed
  std::vector<TurnPoint> points;      // of each vertex of the mesh
  std::vector<TurnFace> walls;        // of the jump edges, see turn_contact.hpp
  double largest_radius = 0.0;        // mm, of a vertex
  double smallest_radius = HUGE_VAL;  // mm, of a face
};

}  // namespace impinge

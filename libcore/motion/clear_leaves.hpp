// SPDX-License-Identifier: GPL-3.0-or-later
// Directions divided so that in each part one radius lies between ball and socket.
//
// A part is a node of the quadtree on a face of the cube: with n = 2^level, m = |x_k| where coordinate k of a
// direction is the largest, p and q the next two,  lo m <= n p <= (lo + 2) m,  lo = 2 i - n,  and the same of
// q and j. It is a leaf with the radius r if
//   every point of the ball in its cone is at most r from the centre, and
//   every point x of the socket in its cone has a . x > |a| r,  a the middle of the leaf,
// so that it is farther than r. Both are about convex polygons, whose corners decide. The second is stricter
// than |x| > r by 1 - cos of the leaf's angular radius, but needs no distance of a point from a polygon.
//
// What is computed in doubles has to hold for slightly different numbers: those of the files, before reading
// rounded them. A surface whose points are off by at most d has all that is in a cone within d of
// what the surface at hand has in the cone widened by d, and its distances differ by d at most. A ball that
// turns by a small angle moves no point at a distance H by more than chord H, and no distance changes. So
// cones are widened, and radii kept apart, by d.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

inline constexpr std::int64_t kLeafUnit = 1 << 20;  // radii of leaves are whole numbers of 1 / kLeafUnit mm
inline constexpr int kFinestLeaf = 20;              // level; a part of 2e-6 rad

/// A node of the quadtree on the faces of the cube, with its radius.
struct ClearLeaf {
  int face = 0;             // 2 k where coordinate k is positive, 2 k + 1 where it is negative
  int level = 0;            // 0 is a whole face
  std::int64_t i = 0;       // place along the next coordinate, below 2^level
  std::int64_t j = 0;       // along the one after
  std::int64_t radius = 0;  // in 1 / kLeafUnit mm
};

/// A surface about the centre, mm.
struct UncertainMesh {
  TriangleMesh mesh;
  double off_mm = 0.0;  // no point is farther than this from the true one
};

/// What is asked of two surfaces.
struct LeafQuestion {
  const UncertainMesh& ball;    // in the middle of the turn
  const UncertainMesh& socket;  // at rest
  double chord =
      0.0;  // the ball turns to either side and moves no point by more than this share of its distance
  int finest = kFinestLeaf;  // level
};

/// How the directions were divided: all of them, or why not.
struct LeafAnswer {
  std::vector<ClearLeaf> leaves;  // cover every direction, unless one of the others is there
  /// A direction along which the ball certainly reaches the socket. Only looked for where chord is 0.
  std::optional<std::array<std::int64_t, 3>> ray;
  std::optional<Vec3> open;  // a direction where the surfaces are too near to each other to be told apart

  bool clear() const { return !ray && !open; }
};

/// Divides until each part has a radius, a ray shows that none has, or the finest parts are reached.
LeafAnswer clear_leaves(const LeafQuestion& question);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Do ball and socket stand to each other as they do in a joint? Known as scanned, before any motion.
#pragma once

#include "hip/anatomy.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// What the centre sees of both: the outermost layer of the ball and the nearest of the socket, every 4
/// degrees. Shares of the view are solid angles in one unit of any size.
struct Facing {
  double ball_covers = 0.0;  // share of the view
  double socket_covers = 0.0;
  double common = 0.0;       // of directions in which both are met
  double outside = 0.0;      // of those, where the socket is the nearer
  double ball_radius = 0.0;  // mm, median over the directions of the ball; NaN if it has none
  double nearest =
      0.0;  // mm, least radius of the socket minus that of the ball there; infinite if `common` is 0
  double ratio = 0.0;  // of the radii, socket over ball, median over `common`; NaN if there is none
};

/// Meshes in the centre frame, mm.
Facing facing(const TriangleMesh& ball, const TriangleMesh& socket);

/// Have the two files changed places? So it is where "ball" lies outside of "socket" in most of the
/// directions that both cover, and is a cap or covers fewer directions than it: a ball that is merely too
/// large still closes about its centre more than the socket does.
bool look_swapped(const Facing& facing, bool cap);

/// Does the socket lie on the lateral side of the ball? That of a hip or a shoulder lies towards the midline:
/// to the left of a right ball. Joint frame, the centre as origin.
bool looks_lateral(const TriangleMesh& socket, Side side);

}  // namespace impinge

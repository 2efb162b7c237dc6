// SPDX-License-Identifier: GPL-3.0-or-later
// Checks, in the pose of the scan, whether ball and socket are placed as in a joint.
#pragma once

#include "hip/anatomy.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Both surfaces as seen from the centre, sampled every 4 degrees: the outermost layer of the ball and the
/// nearest layer of the socket. Shares of the view are solid angles, all in the same arbitrary unit.
struct Facing {
  double ball_covers = 0.0;  // share of the view
  double socket_covers = 0.0;
  double common = 0.0;       // share in which both are met
  double outside = 0.0;      // part of `common` where the socket is nearer to the centre than the ball
  double ball_radius = 0.0;  // mm, median over the directions of the ball; NaN if it has none
  double nearest = 0.0;      // mm, least difference of radii, socket minus ball; infinite if `common` is 0
  double ratio = 0.0;        // median ratio of radii, socket over ball, over `common`; NaN if that is 0
};

/// Meshes in the centre frame, mm.
Facing facing(const TriangleMesh& ball, const TriangleMesh& socket);

/// Were the two files swapped? True if the ball lies beyond the socket in more than 70 % of the directions
/// that both cover, and the ball is a cap (`cap`) or covers fewer directions than the socket. A ball that is
/// merely too large still covers more directions than the socket.
bool look_swapped(const Facing& facing, bool cap);

/// Does the socket lie on the lateral side of the ball? In a hip or a shoulder it lies medially: to the left
/// of a right ball. Joint frame, the centre as origin.
bool looks_lateral(const TriangleMesh& socket, Side side);

}  // namespace impinge

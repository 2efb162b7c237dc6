// SPDX-License-Identifier: GPL-3.0-or-later
// Do ball and socket stand to each other as they do in a joint? Known as scanned, before any motion.
#pragma once

#include "joint/anatomy.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

// Have the two files changed places? So it is where "ball" lies outside of "socket" in most of the directions
// that both cover, and covers fewer directions than it: a ball that is merely too large still closes about
// its centre more than the socket does. Centre frame, mm.
bool look_swapped(const TriangleMesh& ball, const TriangleMesh& socket);

// Does the socket lie on the lateral side of the ball? That of a hip or a shoulder lies towards the midline:
// to the left of a right ball. Joint frame, the centre as origin.
bool looks_lateral(const TriangleMesh& socket, Side side);

}  // namespace impinge

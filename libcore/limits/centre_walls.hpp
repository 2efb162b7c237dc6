// SPDX-License-Identifier: GPL-3.0-or-later
// Jump edges of a surface for every centre within a distance of the origin, and the walls that come with
// them.
#pragma once

#include <vector>

#include "contact/turn_surface.hpp"
#include "mesh/edges.hpp"

namespace impinge {

/// Edges that are jump edges (mesh/jump_edges.hpp) for some centre within r mm of the origin, and perhaps
/// others: all but those of two faces that spread to opposite sides, both with planes farther than r.
std::vector<Edge> possible_jumps(const TriangleMesh& mesh, double r);

/// What walls are wanted.
struct WallQuestion {
  bool beyond = true;     // beyond the edges, of a socket; else within them, of a ball
  bool common = true;     // CentreDoubt::common; else CentreDoubt::play
  double r = 0.0;         // mm
  double gap = 0.0;       // threshold, mm
  double nearest = 0.0;   // mm, least radius of the points that are to meet them
  double farthest = 0.0;  // mm, largest radius of these
};

/// The walls { k y } of the edges, as triangles between two values of k; their `doubt` is what
/// limits/centre_interval.hpp adds there to the shift of the ball.
std::vector<TurnFace> shells(const TriangleMesh& mesh, const std::vector<Edge>& edges,
                             const WallQuestion& walls);

}  // namespace impinge

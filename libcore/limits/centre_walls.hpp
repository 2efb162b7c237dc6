// SPDX-License-Identifier: GPL-3.0-or-later
// Jump edges of a surface for every centre within a distance of the origin, and the walls beyond or within
// them that limits/centre_interval.hpp needs for a threshold of the gap.
#pragma once

#include <vector>

#include "contact/turn_surface.hpp"
#include "mesh/edges.hpp"

namespace impinge {

/// All edges that are jump edges (mesh/jump_edges.hpp) for some centre within r mm of the origin, and perhaps
/// others. Left out are edges of two faces on opposite sides whose planes are both farther than r.
std::vector<Edge> possible_jumps(const TriangleMesh& mesh, double r);

/// Which walls are wanted.
struct WallQuestion {
  bool beyond = true;     // beyond the edges of a socket; false: within those of a ball
  bool common = true;     // CentreDoubt::common; false: CentreDoubt::play
  double r = 0.0;         // mm, as in possible_jumps()
  double gap = 0.0;       // threshold, mm
  double nearest = 0.0;   // mm, least radius of the points that may come to the walls
  double farthest = 0.0;  // mm, largest radius of these points
};

/// The walls { k y } over points y of the edges, mm, cut into shells between two values of k, two triangles
/// each. `doubt` of a triangle is what its distance allows for besides the shift of the ball and the
/// threshold.
std::vector<TurnFace> shells(const TriangleMesh& mesh, const std::vector<Edge>& edges,
                             const WallQuestion& walls);

}  // namespace impinge

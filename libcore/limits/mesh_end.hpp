// SPDX-License-Identifier: GPL-3.0-or-later
// At which angle of a turn does a point of the socket pass the border of the ball's mesh? A scan that holds a
// cap of bone or a sheet of cartilage says nothing of what lies beyond its border.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "limits/sinusoid.hpp"
#include "mesh/edges.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// A ball that turns over points of a socket at rest, all in the frame whose +z is the axis, mm.
struct MeshEnd {
  std::vector<Vec3> ball;    // its vertices
  std::vector<Edge> border;  // its jump edges (mesh/jump_edges.hpp), at a rim or where a shell turns back
  std::vector<Vec3> socket;  // points whose rays are followed
  /// Does the ray through that socket point meet the ball when it has turned by `angle` radians?
  std::function<bool(std::size_t point, double angle)> covered;
};

/// The first angle up to `largest`, radians, at which a point that was covered at the start passes the border
/// and is not covered 1e-9 rad later; none if there is none.
std::optional<double> first_beyond(const MeshEnd& end, double largest);

/// The same for centres up to `within` mm away, with rays to points of the socket that are shifted by up to
/// `shift` mm: an angle before which no such point passes the border about any of them. A point that is not
/// covered about the given centre is not followed, though it may be about another.
std::optional<double> first_near_border(const MeshEnd& end, double largest, double shift, double within);

}  // namespace impinge

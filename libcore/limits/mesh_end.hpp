// SPDX-License-Identifier: GPL-3.0-or-later
// Where the mesh of the ball ends: a scan that holds a cap of bone or a sheet of cartilage says nothing of
// what lies beyond its border.
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
  std::vector<Edge> border;  // its jump edges (mesh/jump_edges.hpp): of a rim, or of a shell that turns back
  std::vector<Vec3> socket;  // points whose directions are asked for
  /// Does the ray through that socket point meet the ball when it has turned by `angle` radians?
  std::function<bool(std::size_t point, double angle)> covered;
};

/// The first angle up to `largest`, radians, at which a point that was covered at the start passes a border
/// of the ball and is not covered behind it; to rounding, about 1e-9.
std::optional<double> first_beyond(const MeshEnd& end, double largest);

}  // namespace impinge

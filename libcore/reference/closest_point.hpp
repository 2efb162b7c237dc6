// SPDX-License-Identifier: GPL-3.0-or-later
// The reference for Euclidean distances: how far a point is from the nearest point of a mesh, exact but for
// one rounding.
//
// The squared distance of x from a face is the least of
//   (n.(x - v0))^2 / n.n     if the foot of x on its plane lies in the face,
//   |e x (x - a)|^2 / e.e    for an edge e from a, if the foot lies on the edge,
//   |x - v|^2                for a corner,
// each a ratio of sums of products of doubles. CGAL's tree of boxes finds the faces that may be nearest. The
// ratios are compared exactly, as integers, and the root of the least is rounded once: each distance is the
// double nearest to the true one.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// The points to find distances for.
struct DistanceQuery {
  std::span<const Vec3> points;                    // mm, in the frame of the mesh
  std::function<void(std::size_t)> progress = {};  // called at times with the number of points done
};

/// Distance of each point from the mesh, mm, never negative. Throws std::invalid_argument for a mesh without
/// faces and for coordinates that are not finite. About 150 microseconds a point.
std::vector<double> closest_distances(const TriangleMesh& mesh, const DistanceQuery& query);

}  // namespace impinge

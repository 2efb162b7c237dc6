// SPDX-License-Identifier: GPL-3.0-or-later
// Method cartesian_field: a signed distance field of the socket on a Cartesian grid, read at every vertex of
// the ball (thesis, Section 3.6.2). A node beyond the socket, as seen from the centre, has a negative
// distance. An open surface has no inside, so the values jump at the rim by twice the distance; within a cell
// of that jump an answer means nothing.
#pragma once

#include <vector>

#include "gap/pose.hpp"
#include "mesh/triangle_mesh.hpp"
#include "methods/grid_field.hpp"

namespace impinge::lab {

// Signed distances (mm, in float) at every node, from CGAL's closest points, signs from first hits of rays.
GridField make_signed_field(const TriangleMesh& socket, const DistanceGridShape& shape);

class CartesianField {
 public:
  // Meshes in their centre frames, mm.
  CartesianField(const TriangleMesh& ball, GridField socket)
      : ball_(ball.vertices), socket_(std::move(socket)), distance_(ball_.size()) {}

  bool touches(const Pose& pose) {
    bool touching = false;
    for (std::size_t i = 0; i < ball_.size(); ++i) {
      distance_[i] = socket_.at(to_socket(pose, ball_[i]));
      touching = touching || distance_[i] <= 0.0;  // NaN outside the grid
    }
    return touching;
  }

  // Distances of the ball's vertices in the last pose, mm.
  const std::vector<double>& distances() const { return distance_; }
  std::size_t bytes() const { return socket_.bytes(); }  // of the grid

 private:
  std::vector<Vec3> ball_;
  GridField socket_;
  std::vector<double> distance_;
};

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// Method maciel_triangles: the spherical method of Maciel et al. (2007) as the thesis describes it (Section
// 2.4): the ball's table of triangles by direction; every vertex of the socket is compared exactly with the
// triangle of its direction. A vertex whose ray misses that triangle is not tested: it may lie under a
// triangle that the table lost. Only one scan, socket vertices against the ball.
#pragma once

#include <utility>
#include <vector>

#include "gap/pose.hpp"
#include "methods/triangle_table.hpp"

namespace impinge::lab {

class MacielTriangles {
 public:
  // The table is that of the ball, farthest layer. Meshes in their centre frames, mm; they are copied.
  MacielTriangles(TriangleMesh ball, const TriangleMesh& socket, TriangleTable table)
      : ball_(std::move(ball)), socket_(socket.vertices), table_(std::move(table)), gap_(socket_.size()) {}

  bool touches(const Pose& pose);
  // Radius of the ball along y (ball frame), mm; NaN where the triangle of that direction is not met.
  double radius(const Vec3& y) const { return radius_at(table_, ball_, y); }

  // |y| - radius(y) of the socket's vertices y in the last pose, mm; NaN for those not tested.
  const std::vector<double>& gaps() const { return gap_; }
  // Of the table and of the triangles it refers to.
  std::size_t bytes() const {
    return table_.bytes() + ball_.vertices.size() * sizeof(Vec3) + ball_.faces.size() * sizeof(Face);
  }

 private:
  TriangleMesh ball_;
  std::vector<Vec3> socket_;
  TriangleTable table_;
  std::vector<double> gap_;
};

}  // namespace impinge::lab

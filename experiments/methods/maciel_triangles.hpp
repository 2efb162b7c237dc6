// SPDX-License-Identifier: GPL-3.0-or-later
// Method maciel_triangles: the spherical method of Maciel et al. (2007) as the thesis tells it (Section 2.4):
// the ball's table of triangles by direction, and every vertex of the socket against the triangle of its
// direction, exactly. A vertex that does not meet that triangle is not tested: it may lie under a triangle
// that the table lost. One scan alone, socket vertices against the ball.
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
  // Of the ball along a point of its frame, mm; NaN where the triangle of its direction is not met.
  double radius(const Vec3& y) const { return radius_at(table_, ball_, y); }

  // |y| - B(y) of the socket's vertices in the last pose that was tested, mm; NaN where none was tested.
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

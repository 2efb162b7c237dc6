// SPDX-License-Identifier: GPL-3.0-or-later
// Method maciel_triangles: the spherical method of Maciel et al. (2007) as the thesis tells it (Section 2.4):
// the ball's table of triangles by direction, and every vertex of the socket against the triangle of its
// direction, exactly. A vertex that does not meet that triangle is not tested: it may lie under a triangle
// that the table lost. One scan alone, socket vertices against the ball.
#pragma once

#include <utility>
#include <vector>

#include "methods/touch_method.hpp"
#include "methods/triangle_table.hpp"

namespace impinge::lab {

class MacielTriangles final : public TouchMethod {
 public:
  // The table is that of the ball, farthest layer. Meshes in their centre frames, mm; they are copied.
  MacielTriangles(TriangleMesh ball, const TriangleMesh& socket, TriangleTable table)
      : ball_(std::move(ball)), socket_(socket.vertices), table_(std::move(table)), gap_(socket_.size()) {}

  std::string_view name() const override { return "maciel_triangles"; }
  // Published without; its projection on the triangle would give the radial gap of the tested vertices.
  bool gives_distance() const override { return false; }
  bool touches(const Pose& pose) override;

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

// SPDX-License-Identifier: GPL-3.0-or-later
// Method maciel_triangles: the spherical method of Maciel et al. (2007) as the thesis describes it (Section
// 2.4). A table gives the ball's triangle for each direction; every vertex of the socket is compared exactly
// with the triangle of its direction. If its ray misses that triangle the vertex is not tested, though it may
// lie under a triangle that the table lost. Only the socket's vertices are scanned.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "gap/pose.hpp"
#include "mesh/triangle_mesh.hpp"
#include "table/layer.hpp"

namespace impinge::lab {

// A table with one triangle per direction, as in Maciel et al. (2007) (thesis, Sections 2.4 and 3.6.3).
//
// There are side x side rays: row i at the polar angle (i + 1/2) 180 / side degrees, column j at the azimuth
// (j + 1/2) 360 / side. A ray represents the patch of directions about it and refers to the one triangle that
// it meets. Triangles that no ray meets are lost: the capturing error.

inline constexpr std::uint32_t kNoFace = std::numeric_limits<std::uint32_t>::max();  // no triangle is met

struct TriangleTable {
  std::size_t side = 0;             // rays per side of the square of rays
  std::vector<std::uint32_t> face;  // of each ray, row by row; kNoFace where none is met

  std::size_t bytes() const { return face.size() * sizeof(std::uint32_t); }  // of the face numbers
};

// Unit vector of a ray, by its number (row by row), in a table with this side.
Vec3 ray_direction(std::size_t side, std::size_t ray);
std::size_t ray_of(std::size_t side, const Vec3& x);  // number of the ray in whose patch x is; x not 0

// Radius along x (any length above zero) of a face, mm, boundary included; kNoSurface where x does not meet
// it: r = det(a, b, c) / (det(u, b, c) + det(a, u, c) + det(a, b, u)) with all three of one sign.
double radius_on(const TriangleMesh& mesh, const Face& face, const Vec3& x);

// Tests every ray against every triangle, O(rays x triangles), as published. `mesh` is in the centre frame.
// Of triangles at the same distance along a ray the first is kept. Throws std::invalid_argument for side 0.
TriangleTable fill_triangles_pairwise(const TriangleMesh& mesh, std::size_t side, Layer layer);

// The same table, faster: tests each triangle only against rays near it.
TriangleTable fill_triangles(const TriangleMesh& mesh, std::size_t side, Layer layer);

// Radius along x (mm) of the triangle for x's ray; kNoSurface if there is none or x does not meet it.
double radius_at(const TriangleTable& table, const TriangleMesh& mesh, const Vec3& x);

// Faces that no ray refers to. Faces whose plane holds the centre exactly cannot be met and do not count.
std::size_t missed_faces(const TriangleTable& table, const TriangleMesh& mesh);

class MacielTriangles {
 public:
  // `table` is the ball's, farthest layer. Meshes in their centre frames, mm; they are copied.
  MacielTriangles(TriangleMesh ball, const TriangleMesh& socket, TriangleTable table)
      : ball_(std::move(ball)), socket_(socket.vertices), table_(std::move(table)), gap_(socket_.size()) {}

  bool touches(const Pose& pose);
  // Radius of the ball along y (ball frame), mm; NaN if the triangle of that direction is not met.
  double radius(const Vec3& y) const { return radius_at(table_, ball_, y); }

  // |y| - radius(y) for the socket's vertices y in the last pose, mm; NaN for vertices that were not tested.
  const std::vector<double>& gaps() const { return gap_; }
  // Memory of the table and of the triangles that it refers to.
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/triangle_mesh.hpp"

#include <Eigen/Geometry>

namespace impinge {

Vec3 area_vector(const TriangleMesh& mesh, const Face& face) {
  const Vec3& a = corner(mesh, face, 0);
  return (corner(mesh, face, 1) - a).cross(corner(mesh, face, 2) - a);
}

std::vector<double> vertex_areas(const TriangleMesh& mesh) {
  std::vector<double> area(mesh.vertices.size(), 0.0);
  for (const Face& face : mesh.faces) {
    const double third = area_vector(mesh, face).norm() / 6.0;
    for (const VertexIndex v : face) area[v] += third;
  }
  return area;
}

TriangleMesh relative_to(TriangleMesh mesh, const Vec3& centre) {
  for (Vec3& v : mesh.vertices) v -= centre;
  return mesh;
}

// Not done in place, which LLVM 14 compiled wrongly for WebAssembly (see the top CMakeLists.txt).
std::vector<Vec3> mapped(const Eigen::Matrix3d& matrix, const std::vector<Vec3>& points) {
  std::vector<Vec3> images;
  images.reserve(points.size());
  for (const Vec3& x : points) images.emplace_back(matrix * x);
  return images;
}

}  // namespace impinge

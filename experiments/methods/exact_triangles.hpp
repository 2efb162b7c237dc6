// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of a mesh for CGAL, with double coordinates and exact predicates.
#pragma once

#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "gap/pose.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// CGAL's kernel with exact predicates.
using ExactPredicates = CGAL::Exact_predicates_inexact_constructions_kernel;

// Faces of the posed mesh in socket coordinates. Exactly degenerate faces are left out: they have no
// interior, and CGAL's predicates do not accept them.
inline std::vector<ExactPredicates::Triangle_3> exact_triangles(const TriangleMesh& mesh,
                                                                const Pose& pose = {}) {
  std::vector<ExactPredicates::Point_3> points;
  points.reserve(mesh.vertices.size());
  for (const Vec3& vertex : mesh.vertices) {
    const Vec3 x = to_socket(pose, vertex);
    points.emplace_back(x.x(), x.y(), x.z());
  }
  std::vector<ExactPredicates::Triangle_3> triangles;
  triangles.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) {
    const ExactPredicates::Triangle_3 triangle(points[face[0]], points[face[1]], points[face[2]]);
    if (!triangle.is_degenerate()) triangles.push_back(triangle);
  }
  return triangles;
}

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// Faces are cut without a gap between them, and the surface stays where it was.
#include "mesh/split_faces.hpp"

#include <random>

#include <gtest/gtest.h>

#include "mesh/edges.hpp"
#include "mesh/icosphere.hpp"

namespace impinge {
namespace {

double area_of(const TriangleMesh& mesh) {
  double area = 0.0;
  for (const Face& face : mesh.faces) area += 0.5 * area_vector(mesh, face).norm();
  return area;
}

double smallest_angle(const TriangleMesh& mesh) {
  double smallest = kPi;
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 at = corner(mesh, face, k);
      smallest = std::min(smallest, angle_between(corner(mesh, face, (k + 1) % 3) - at,
                                                  corner(mesh, face, (k + 2) % 3) - at));
    }
  }
  return smallest;
}

TEST(SplitFaces, LeaveNoCornerOnASideHoweverTheyAreMarked) {
  std::mt19937_64 engine(7);
  TriangleMesh mesh = icosphere(10.0, 1);
  const double area = area_of(mesh);
  const double angle = smallest_angle(mesh);
  for (int round = 0; round < 8; ++round) {
    std::vector<bool> marked(mesh.faces.size());
    for (std::size_t f = 0; f < marked.size(); ++f) marked[f] = engine() % 16 == 0 || f == 0;
    const SplitFaces split = split_faces(mesh, marked);
    ASSERT_EQ(split.parent.size(), split.mesh.faces.size());
    std::vector<double> of_parent(mesh.faces.size(), 0.0);
    std::vector<int> parts(mesh.faces.size(), 0);
    for (std::size_t f = 0; f < split.parent.size(); ++f) {
      of_parent[split.parent[f]] += 0.5 * area_vector(split.mesh, split.mesh.faces[f]).norm();
      ++parts[split.parent[f]];
    }
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      EXPECT_NEAR(of_parent[f], 0.5 * area_vector(mesh, mesh.faces[f]).norm(), 1e-12);
      EXPECT_TRUE(!marked[f] || parts[f] == 4);
    }
    for_each_edge(split.mesh, [](std::span<const HalfEdge> sides) { EXPECT_EQ(sides.size(), 2U); });
    EXPECT_TRUE(boundary_edges(split.mesh).empty());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      EXPECT_EQ(split.mesh.vertices[v], mesh.vertices[v]);
    mesh = split.mesh;
  }
  EXPECT_NEAR(area_of(mesh), area, 1e-9 * area);
  EXPECT_GE(smallest_angle(mesh), 0.5 * angle - 1e-9);
}

TEST(SplitFaces, LeaveAllAsItIsWhereNoneIsMarked) {
  const TriangleMesh mesh = icosphere(10.0, 1);
  const SplitFaces split = split_faces(mesh, std::vector<bool>(mesh.faces.size(), false));
  EXPECT_EQ(split.mesh.faces, mesh.faces);
  EXPECT_EQ(split.mesh.vertices.size(), mesh.vertices.size());
}

}  // namespace
}  // namespace impinge

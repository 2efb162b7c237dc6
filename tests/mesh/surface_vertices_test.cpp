// SPDX-License-Identifier: GPL-3.0-or-later
// A vertex is on the surface exactly where a face has it whose plane does not hold the centre.
#include "mesh/surface_vertices.hpp"

#include <gtest/gtest.h>

namespace impinge {
namespace {

TEST(SurfaceVertices, AreThoseOfFacesInTheOrderOfTheMesh) {
  const TriangleMesh mesh{{{1, 0, 0}, {0, 1, 0}, {1, 1, 1}, {0, 0, 1}, {1, 1, 1}, {1, 1, 2}},
                          {{5, 1, 3}, {3, 1, 0}}};
  EXPECT_EQ(on_surface(mesh), (std::vector<bool>{true, true, false, true, false, true}));
  EXPECT_EQ(surface_vertices(mesh), (std::vector<VertexIndex>{0, 1, 3, 5}));
}

// A face in a plane through the centre, one without area, one with a corner in the centre, one the first
// rounding away from that; then what is left.
TEST(SurfaceVertices, OfEdgeOnFacesAloneAreNone) {
  const TriangleMesh mesh{{{10, 0, 4},
                           {4, 0, 10},
                           {50, 0, 50},
                           {1, 2, 3},
                           {2, 3, 4},
                           {3, 4, 5},
                           {0, 0, 0},
                           {10, 0x1p-49, 4},
                           {1, 1, 1}},
                          {{0, 1, 2}, {3, 4, 5}, {6, 8, 3}, {7, 1, 2}, {1, 2, 8}}};
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) EXPECT_EQ(is_edge_on(mesh, mesh.faces[f]), f < 3) << f;
  EXPECT_EQ(surface_vertices(mesh), (std::vector<VertexIndex>{1, 2, 7, 8}));
  const TriangleMesh surface = without_edge_on(mesh);
  EXPECT_EQ(surface.faces, (std::vector<Face>{{7, 1, 2}, {1, 2, 8}}));
  EXPECT_EQ(surface.vertices, mesh.vertices);
}

TEST(SurfaceVertices, OfNoFacesAreNone) {
  TriangleMesh mesh;
  mesh.vertices.resize(2, Vec3::UnitX());
  EXPECT_EQ(on_surface(mesh), std::vector<bool>(2, false));
  EXPECT_TRUE(surface_vertices(mesh).empty());
}

}  // namespace
}  // namespace impinge

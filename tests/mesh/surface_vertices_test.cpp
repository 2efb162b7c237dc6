// SPDX-License-Identifier: GPL-3.0-or-later
// A vertex is on the surface exactly where a face has it.
#include "mesh/surface_vertices.hpp"

#include <gtest/gtest.h>

namespace impinge {
namespace {

TEST(SurfaceVertices, AreThoseOfFacesInTheOrderOfTheMesh) {
  TriangleMesh mesh;
  mesh.vertices.resize(6, Vec3::UnitX());
  mesh.faces = {{5, 1, 3}, {3, 1, 0}};
  EXPECT_EQ(on_surface(mesh), (std::vector<bool>{true, true, false, true, false, true}));
  EXPECT_EQ(surface_vertices(mesh), (std::vector<VertexIndex>{0, 1, 3, 5}));
}

TEST(SurfaceVertices, OfNoFacesAreNone) {
  TriangleMesh mesh;
  mesh.vertices.resize(2, Vec3::UnitX());
  EXPECT_EQ(on_surface(mesh), std::vector<bool>(2, false));
  EXPECT_TRUE(surface_vertices(mesh).empty());
}

}  // namespace
}  // namespace impinge

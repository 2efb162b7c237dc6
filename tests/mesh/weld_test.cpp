// SPDX-License-Identifier: GPL-3.0-or-later
// Kept vertices are pairwise different and in their order, a face has the corners that it had, and faces that
// collapse are left out.
#include "mesh/weld.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "support/joined.hpp"

namespace impinge {
namespace {

TEST(Weld, RestoresASharedMeshFromItsSoup) {
  const TriangleMesh mesh = sphere(25.0, 1000);
  TriangleMesh soup;  // three vertices of its own for every face, as in STL
  for (const Face& face : mesh.faces)
    test::add_face(soup, corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2));
  for (const TriangleMesh& given : {soup, mesh}) {
    EXPECT_EQ(weld(given).faces, mesh.faces);
    EXPECT_EQ(weld(given).vertices, mesh.vertices);
  }
  EXPECT_TRUE(weld({}).vertices.empty());
}

TEST(Weld, ZeroHasNoSign) {
  EXPECT_EQ(weld({{{0.0, 1.0, -0.0}, {-0.0, 1.0, 0.0}, {0.0, -1.0, 0.0}}, {}}).vertices.size(), 2U);
}

TEST(Weld, ExactMeansEveryBit) {
  const double next = std::nextafter(1.0, 2.0);
  EXPECT_EQ(weld({{{1.0, 0, 0}, {next, 0, 0}, {1.0, 0, 0}}, {}}).vertices,
            (std::vector<Vec3>{{1.0, 0, 0}, {next, 0, 0}}));
}

TEST(Weld, NanStaysAlone) {
  const Vec3 nan(std::nan(""), 0.0, 0.0);
  EXPECT_EQ(weld({{nan, nan, Vec3::Zero(), Vec3::Zero()}, {}}).vertices.size(), 3U);
}

TEST(Weld, CollapsedFacesAreDroppedAndTheRestKeepTheirOrder) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {5, 5, 5}},
                          {{0, 1, 2}, {0, 1, 3}, {2, 3, 4}, {4, 4, 0}}};
  EXPECT_EQ(weld(mesh).faces, (std::vector<Face>{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_EQ(weld(mesh).vertices.size(), 4U);
}

TEST(Weld, RefusesAFaceOfAVertexThatIsNotThere) {
  EXPECT_THROW(weld({{{0, 0, 0}}, {{0, 0, 1}}}), std::out_of_range);
}

}  // namespace
}  // namespace impinge

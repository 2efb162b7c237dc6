// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres put into one mesh are its pieces again, whatever the order of their faces.
#include "mesh/mesh_pieces.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/validation.hpp"
#include "support/joined.hpp"

namespace impinge {
namespace {

// A ball, a screw that begins inside of it with as many faces, and a speck.
TriangleMesh ball_screw_and_speck() {
  TriangleMesh screw = sphere(2.0, 400);
  for (Vec3& x : screw.vertices) x = Vec3(x.x(), x.y(), 10.0 * x.z());
  return test::joined(test::joined(sphere(0.5, 20, {30.0, 0.0, 0.0}), screw), sphere(16.0, 400));
}

TEST(MeshPieces, TheLargestOfAreaIsTheFirst) {
  TriangleMesh mesh = ball_screw_and_speck();
  std::ranges::shuffle(mesh.faces, std::mt19937(1));
  const std::vector<MeshPiece> pieces = mesh_pieces(mesh);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_NEAR(pieces[0].area, 4.0 * kPi * 256.0, 60.0);
  EXPECT_EQ(pieces[1].faces.size(), 400U);
  EXPECT_EQ(pieces[2].faces.size(), 20U);
  EXPECT_EQ(sizes_text(pieces), "32.0, 40.0 and 1.0 mm across");
}

TEST(MeshPieces, KeptAloneItIsTheMeshThatItWas) {
  TriangleMesh mesh = ball_screw_and_speck();
  EXPECT_EQ(keep_largest_piece(mesh), "2 of its 3 pieces left out, 40.0 and 1.0 mm across");
  EXPECT_EQ(mesh.vertices, sphere(16.0, 400).vertices);
  EXPECT_EQ(mesh.faces, sphere(16.0, 400).faces);
  EXPECT_EQ(keep_largest_piece(mesh), "");
}

TEST(MeshPieces, OfManyTheFirstFourAreNamed) {
  TriangleMesh mesh = sphere(16.0, 100);
  for (int k = 0; k < 20; ++k) mesh = test::joined(mesh, sphere(1.0, 20, {0.0, 0.0, 30.0 + 5.0 * k}));
  EXPECT_EQ(keep_largest_piece(mesh),
            "20 of its 21 pieces left out, 2.0, 2.0, 2.0, 2.0 mm across and others");
}

// As the report of a mesh put together from them.
TEST(MeshReport, TheSumIsThatOfTheWhole) {
  TriangleMesh flipped = sphere(3.0, 100, {40.0, 0.0, 0.0});
  std::swap(flipped.faces[7][0], flipped.faces[7][1]);
  TriangleMesh open = sphere(5.0, 60, {0.0, 40.0, 0.0});
  open.faces.pop_back();
  open.vertices.emplace_back(1.0, 2.0, 3.0);
  MeshReport sum = validate(sphere(16.0, 400));
  TriangleMesh whole = sphere(16.0, 400);
  for (const TriangleMesh& more : {sphere(2.0, 20, {0.0, 0.0, 50.0}), flipped, open}) {
    whole = test::joined(whole, more);
    sum += validate(more);
    const MeshReport truth = validate(whole);
    EXPECT_EQ(describe(sum), describe(truth));
    EXPECT_EQ(sum.closed(), truth.closed());
    EXPECT_EQ(sum.volume.has_value(), truth.volume.has_value());
  }
}

}  // namespace
}  // namespace impinge

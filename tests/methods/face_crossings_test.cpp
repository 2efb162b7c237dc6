// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: pairs of faces without a common vertex that share a point, in order, the smaller number first.
#include "methods/face_crossings.hpp"

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"

namespace impinge::lab {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

TEST(FaceCrossings, FindWhatCrossesAndNoNeighbours) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0},  {4, 0, 0}, {0, 4, 0},  // face 0
                   {1, 1, -1}, {1, 1, 1}, {1, 2, 1},  // face 1 goes through it
                   {9, 9, -1}, {9, 9, 1}, {9, 8, 1},  // face 2 is elsewhere
                   {0, 0, 5},  {-3, 0, 5}};           // face 3 shares vertex 0 with face 0
  mesh.faces = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {0, 9, 10}, {0, 0, 1}};
  EXPECT_EQ(face_crossings(mesh), (Pairs{{0, 1}}));
  mesh.vertices[3] = {1, 1, 0};
  mesh.vertices[4] = {1, 1, 2};
  EXPECT_EQ(face_crossings(mesh), (Pairs{{0, 1}})) << "a corner on the face is a common point";
  mesh.vertices[3].z() = 1e-300;
  EXPECT_TRUE(face_crossings(mesh).empty());
}

TEST(FaceCrossings, ABodyHasNone) { EXPECT_TRUE(face_crossings(sphere(20.0, 200)).empty()); }

}  // namespace
}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: each flaw put into a sound mesh is counted, once, and nothing else is; the report of a sound mesh
// is clean. Volume of a closed mesh: sum of v0.(v1 x v2) / 6.
#include "mesh/validation.hpp"

#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/disjoint_sets.hpp"
#include "support/joined.hpp"
#include "support/turned.hpp"

namespace impinge {
namespace {

std::size_t flaws(const MeshReport& r) {
  return r.unreferenced_vertices + r.non_finite_vertices + r.invalid_faces + r.degenerate_faces +
         r.duplicate_faces + r.flipped_faces + r.non_manifold_edges + (r.orientable ? 0 : 1);
}

TEST(Validate, EmptyMesh) {
  const MeshReport report = validate({});
  EXPECT_EQ(flaws(report), 0U);
  EXPECT_FALSE(report.closed());
  EXPECT_FALSE(report.volume);
}

TEST(Validate, SoundBodies) {
  const MeshReport report = validate(sphere(10.0, 500));
  EXPECT_EQ(flaws(report), 0U);
  EXPECT_TRUE(report.closed());
  EXPECT_EQ(report.components, 1U);
  EXPECT_NEAR(*report.volume, 4.0 / 3.0 * kPi * 1000.0, 100.0);
  const MeshReport open = validate(cup(10.0, 87.0, 500));
  EXPECT_EQ(flaws(open), 0U);
  EXPECT_FALSE(open.closed());
  EXPECT_FALSE(open.volume);
}

TEST(Validate, VolumeFarFromTheOrigin) {
  const TriangleMesh mesh = test::moved(octahedron(1.0), {4096.0, -4096.0, 65536.0});
  EXPECT_NEAR(*validate(mesh).volume, 4.0 / 3.0, 1e-10);
}

TEST(Validate, InsideOutIsANegativeVolumeAndNoFlip) {
  TriangleMesh mesh = octahedron(3.0);
  for (Face& face : mesh.faces) std::swap(face[0], face[1]);
  const MeshReport report = validate(mesh);
  EXPECT_EQ(report.volume, -36.0);
  EXPECT_EQ(flaws(report), 0U);
}

TEST(Validate, UnreferencedAndNonFiniteVertices) {
  TriangleMesh mesh = octahedron(1.0);
  mesh.vertices.insert(mesh.vertices.end(), {{1, 2, 3}, {4, 5, 6}});
  EXPECT_EQ(validate(mesh).unreferenced_vertices, 2U);
  EXPECT_EQ(flaws(validate(mesh)), 2U);
  mesh = octahedron(1.0);
  mesh.vertices[2].y() = std::nan("");
  mesh.vertices[4].z() = -std::numeric_limits<double>::infinity();
  const MeshReport report = validate(mesh);
  EXPECT_EQ(report.non_finite_vertices, 2U);
  EXPECT_EQ(flaws(report), 2U);
  EXPECT_TRUE(report.closed());
  EXPECT_FALSE(report.volume);
}

TEST(Validate, InvalidFacesAreLeftOutOfTheRest) {
  TriangleMesh mesh = octahedron(1.0);
  mesh.faces.insert(mesh.faces.end(), {{0, 1, 6}, {4000000000U, 4000000000U, 4000000000U}});
  const MeshReport report = validate(mesh);
  EXPECT_EQ(report.invalid_faces, 2U);
  EXPECT_EQ(flaws(report), 2U);
  EXPECT_FALSE(report.closed());
}

TEST(Validate, DegenerateFaces) {
  TriangleMesh mesh = octahedron(1.0);
  mesh.faces.push_back({2, 2, 4});  // has no area and takes no part in the topology
  MeshReport report = validate(mesh);
  EXPECT_EQ(report.degenerate_faces, 1U);
  EXPECT_EQ(flaws(report), 1U);
  EXPECT_TRUE(report.closed());
  // A vertex in the middle of an edge, joined by a face without area.
  const TriangleMesh split{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {1, -2, 0}},
                           {{0, 1, 2}, {0, 3, 1}, {0, 4, 3}, {3, 4, 1}}};
  report = validate(split);
  EXPECT_EQ(report.degenerate_faces, 1U);
  EXPECT_EQ(report.boundary_edges, 4U);
  EXPECT_EQ(flaws(report), 1U);
}

TEST(Validate, DuplicateFaces) {
  TriangleMesh mesh = octahedron(1.0);
  mesh.faces.insert(mesh.faces.end(),
                    {mesh.faces[0], {mesh.faces[1][2], mesh.faces[1][1], mesh.faces[1][0]}});
  const MeshReport report = validate(mesh);
  EXPECT_EQ(report.duplicate_faces, 2U);
  EXPECT_EQ(report.non_manifold_edges, 5U);  // of two neighbours, three edges each, one shared
}

TEST(Validate, FlippedFacesAreTheMinority) {
  for (const std::size_t n : {1U, 7U, 100U, 249U}) {
    TriangleMesh mesh = sphere(1.0, 500);
    for (std::size_t f = 0; f < n; ++f) std::swap(mesh.faces[2 * f][0], mesh.faces[2 * f][1]);
    const MeshReport report = validate(mesh);
    EXPECT_EQ(report.flipped_faces, n);
    EXPECT_EQ(flaws(report), n);
    EXPECT_FALSE(report.volume);
  }
}

TEST(Validate, FlipsAreCountedInEachPart) {
  TriangleMesh mesh = test::joined(octahedron(1.0), sphere(9.0, 300));
  for (std::size_t f = 0; f < 6; ++f) std::swap(mesh.faces[f][0], mesh.faces[f][1]);  // 6 of 8: 2 differ
  const MeshReport report = validate(mesh);
  EXPECT_EQ(report.components, 2U);
  EXPECT_EQ(report.flipped_faces, 2U);
}

// Two half twists would be orientable, one is not.
TEST(Validate, MoebiusStrip) {
  for (const bool twisted : {true, false}) {
    TriangleMesh strip;
    constexpr VertexIndex kSteps = 12;
    for (VertexIndex i = 0; i < kSteps; ++i) {
      const double t = 2.0 * kPi * i / kSteps;
      const double roll = twisted ? 0.5 * t : 0.0;
      for (const double s : {-1.0, 1.0}) {
        const double r = 5.0 + s * std::cos(roll);
        strip.vertices.emplace_back(r * std::cos(t), r * std::sin(t), s * std::sin(roll));
      }
      const VertexIndex a = 2 * i;
      const bool last = i + 1 == kSteps;
      const VertexIndex c = last ? (twisted ? 1 : 0) : a + 2;
      const VertexIndex d = last ? (twisted ? 0 : 1) : a + 3;
      strip.faces.insert(strip.faces.end(), {{a, a + 1, c}, {a + 1, d, c}});
    }
    const MeshReport report = validate(strip);
    EXPECT_EQ(report.orientable, !twisted);
    EXPECT_EQ(report.boundary_edges, 2 * kSteps);
    EXPECT_EQ(report.components, 1U);
  }
}

TEST(Validate, NonManifoldEdgeAndComponents) {
  // Three faces at one edge, like a book; and two triangles that share a corner only.
  const TriangleMesh book{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}},
                          {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
  MeshReport report = validate(book);
  EXPECT_EQ(report.non_manifold_edges, 1U);
  EXPECT_EQ(report.boundary_edges, 6U);
  EXPECT_EQ(report.flipped_faces, 0U);  // nothing to compare across that edge
  const TriangleMesh bow{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}};
  report = validate(bow);
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(flaws(report), 0U);
}

TEST(BoundaryEdges, OfOneTriangleInItsDirection) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(boundary_edges(mesh), (std::vector<Edge>{{0, 1}, {1, 2}, {2, 0}}));
}

TEST(BoundaryEdges, HoleLeftByAFace) {
  TriangleMesh mesh = octahedron(1.0);
  const Face removed = mesh.faces[3];
  mesh.faces.erase(mesh.faces.begin() + 3);
  const std::vector<Edge> rim = boundary_edges(mesh);
  std::set<Edge> expected;  // the neighbours run through the hole's edges the other way
  for (std::size_t k = 0; k < 3; ++k) expected.insert({removed[(k + 1) % 3], removed[k]});
  EXPECT_EQ(std::set<Edge>(rim.begin(), rim.end()), expected);
  EXPECT_EQ(rim.size(), 3U);
  EXPECT_TRUE(boundary_edges(octahedron(1.0)).empty());
}

TEST(Edges, EachWithItsFaces) {
  const EdgeList list = edges(octahedron(1.0));
  EXPECT_EQ(list.size(), 12U);
  for (std::size_t e = 0; e < list.size(); ++e) EXPECT_EQ(list[e].size(), 2U);
  EXPECT_EQ(edges({}).size(), 0U);
}

// Parity against a direct colouring: numbers on one side are even, on the other odd.
TEST(DisjointSets, KeepsSides) {
  DisjointSets sets(100);
  for (std::size_t i = 0; i + 7 < 100; ++i) EXPECT_TRUE(sets.join(i, i + 7, true));
  for (std::size_t i = 0; i < 100; ++i) {
    EXPECT_EQ(sets.find(i).root, i % 7);
    EXPECT_EQ(sets.find(i).opposite, i / 7 % 2 == 1);
  }
  EXPECT_TRUE(sets.join(3, 17, false));
  EXPECT_FALSE(sets.join(3, 17, true));
}

TEST(Describe, SaysWhatIsThereAndWhatIsWrong) {
  TriangleMesh mesh = octahedron(3.0);
  EXPECT_EQ(describe(validate(mesh)), "8 faces, 6 vertices, 1 part, closed, volume 36 mm^3");
  mesh.faces.pop_back();
  mesh.faces.push_back({0, 0, 1});
  std::swap(mesh.faces[2][0], mesh.faces[2][1]);
  EXPECT_EQ(
      describe(validate(mesh)),
      "8 faces, 6 vertices, 1 part, open, 3 boundary edges\nflaws: 1 degenerate faces, 1 flipped faces");
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Contract, m' = weld(m).mesh and f the map: v'_f(i) is v_i (exact) or within the tolerance of it; kept
// vertices are pairwise different, or further apart than the tolerance; faces are the old ones through f,
// without those that collapse; all in their old order.
#include "mesh/weld.hpp"

#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/validation.hpp"
#include "support/random_vector.hpp"

namespace impinge {
namespace {

// Three vertices of its own for every face, as in STL.
TriangleMesh soup(const TriangleMesh& mesh) {
  TriangleMesh soup;
  for (const Face& face : mesh.faces) {
    const auto first = static_cast<VertexIndex>(soup.vertices.size());
    for (std::size_t k = 0; k < 3; ++k) soup.vertices.push_back(corner(mesh, face, k));
    soup.faces.push_back({first, first + 1, first + 2});
  }
  return soup;
}

// The definition, in quadratic time.
std::vector<VertexIndex> brute_force_map(const std::vector<Vec3>& vertices, double tolerance) {
  std::vector<Vec3> kept;
  std::vector<VertexIndex> map;
  for (const Vec3& v : vertices) {
    std::size_t best = kept.size();
    for (std::size_t k = 0; k < kept.size(); ++k) {
      const double d = (kept[k] - v).norm();
      if (d <= tolerance && (best == kept.size() || d < (kept[best] - v).norm())) best = k;
    }
    map.push_back(static_cast<VertexIndex>(best));
    if (best == kept.size()) kept.push_back(v);
  }
  return map;
}

TEST(Weld, RestoresASharedMeshFromItsSoup) {
  const TriangleMesh mesh = sphere(25.0, 1000);
  const Weld welded = weld(soup(mesh));
  EXPECT_EQ(welded.mesh.faces, mesh.faces);
  EXPECT_EQ(welded.mesh.vertices, mesh.vertices);
  EXPECT_EQ(welded.merged_vertices, 3000U - 502U);
  EXPECT_EQ(welded.collapsed_faces, 0U);
}

TEST(Weld, NothingToDo) {
  const TriangleMesh mesh = sphere(25.0, 300);
  for (const Weld& welded : {weld(mesh), weld(mesh, 1e-3)}) {
    EXPECT_EQ(welded.mesh.vertices, mesh.vertices);
    EXPECT_EQ(welded.mesh.faces, mesh.faces);
    EXPECT_EQ(welded.merged_vertices, 0U);
    for (VertexIndex i = 0; i < welded.map.size(); ++i) EXPECT_EQ(welded.map[i], i);
  }
  EXPECT_TRUE(weld({}).mesh.vertices.empty());
}

TEST(Weld, ZeroHasNoSign) {
  const Weld welded = weld({{{0.0, 1.0, -0.0}, {-0.0, 1.0, 0.0}, {0.0, -1.0, 0.0}}, {}});
  EXPECT_EQ(welded.map, (std::vector<VertexIndex>{0, 0, 1}));
}

TEST(Weld, ExactMeansEveryBit) {
  const double next = std::nextafter(1.0, 2.0);
  EXPECT_EQ(weld({{{1.0, 0, 0}, {next, 0, 0}, {1.0, 0, 0}}, {}}).map, (std::vector<VertexIndex>{0, 1, 0}));
}

TEST(Weld, NanStaysAlone) {
  const Vec3 nan(std::nan(""), 0.0, 0.0);
  EXPECT_EQ(weld({{nan, nan}, {}}).merged_vertices, 0U);
  EXPECT_EQ(weld({{nan, nan, Vec3::Zero(), Vec3::Zero()}, {}}, 1.0).map,
            (std::vector<VertexIndex>{0, 1, 2, 2}));
}

TEST(Weld, CollapsedFacesAreDroppedAndTheRestKeepTheirOrder) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {5, 5, 5}},
                          {{0, 1, 2}, {0, 1, 3}, {2, 3, 4}, {4, 4, 0}}};
  const Weld welded = weld(mesh);
  EXPECT_EQ(welded.mesh.faces, (std::vector<Face>{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_EQ(welded.collapsed_faces, 2U);
  EXPECT_EQ(welded.merged_vertices, 1U);
}

TEST(Weld, ToleranceIsInclusiveAndVerticesDoNotMove) {
  const Weld welded = weld({{{0, 0, 0}, {0.5, 0, 0}, {0.75, 0, 0}, {1.25, 0, 0}}, {}}, 0.5);
  EXPECT_EQ(welded.map, (std::vector<VertexIndex>{0, 0, 1, 1}));
  EXPECT_EQ(welded.mesh.vertices[1], Vec3(0.75, 0, 0));
}

TEST(Weld, AgreesWithItsDefinition) {
  std::mt19937_64 random(11);
  for (const double scale : {1.0, 1e-3, 1e6}) {
    for (const double offset : {0.0, 1000.0}) {
      std::uniform_real_distribution<double> coordinate(offset - 1.0, offset + 1.0);
      TriangleMesh mesh;
      for (int i = 0; i < 600; ++i) {
        mesh.vertices.push_back(scale * test::random_vector(coordinate, random));
      }
      for (const double tolerance : {0.01, 0.2, 0.9}) {
        const Weld welded = weld(mesh, tolerance * scale);
        EXPECT_EQ(welded.map, brute_force_map(mesh.vertices, tolerance * scale)) << scale << ' ' << tolerance;
        EXPECT_EQ(welded.mesh.vertices.size() < 600U, tolerance > 0.1);
      }
    }
  }
}

TEST(Weld, TinyLengthsAndTolerancesBelowTheLastBit) {
  const std::vector<Vec3> points{{0, 0, 0}, {1e-200, 0, 0}, {3e-200, 0, 0}};
  EXPECT_EQ(weld({points, {}}, 1.5e-200).map, (std::vector<VertexIndex>{0, 0, 1}));
  // Much less than the distance of neighbouring doubles: the same as exact.
  const double next = std::nextafter(1e9, 2e9);
  EXPECT_EQ(weld({{{1e9, 0, 0}, {next, 0, 0}, {1e9, 0, 0}}, {}}, 1e-30).map,
            (std::vector<VertexIndex>{0, 1, 0}));
}

TEST(Weld, ClosesASphereTornByRounding) {
  TriangleMesh mesh = soup(sphere(25.0, 1000));
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> noise(-1e-4, 1e-4);
  for (Vec3& v : mesh.vertices) v += test::random_vector(noise, random);
  EXPECT_FALSE(validate(weld(mesh).mesh).closed());
  const Weld welded = weld(mesh, 1e-3);
  EXPECT_TRUE(validate(welded.mesh).closed());
  EXPECT_EQ(welded.mesh.faces.size(), 1000U);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    EXPECT_LE((welded.mesh.vertices[welded.map[i]] - mesh.vertices[i]).norm(), 1e-3);
  }
}

TEST(Weld, BadArguments) {
  for (const double tolerance : {0.0, -1.0, HUGE_VAL, std::nan("")}) {
    EXPECT_THROW(weld({}, tolerance), std::invalid_argument);
  }
  EXPECT_THROW(weld({{{0, 0, 0}}, {{0, 0, 1}}}), std::out_of_range);
}

}  // namespace
}  // namespace impinge

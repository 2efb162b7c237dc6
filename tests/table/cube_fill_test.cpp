// SPDX-License-Identifier: GPL-3.0-or-later
// Contract, beside packed_table(fill_exact(mesh, scheme, layer)):
//   an entry has a surface here if and only if it has one there
//   |stored - q| <= 41 u q in float and <= 0.51 step + 41 u q in 16 bits, u = 2^-24
//   a cell without an answer there has none here, and no other, but for jumps at the limit
#include "table/fill/cube_fill.hpp"

#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "support/joined.hpp"
#include "support/soup.hpp"
#include "support/turned.hpp"
#include "table/exact_raster.hpp"

namespace impinge {
namespace {

constexpr double kFloatUlp = 0x1p-24;
constexpr float kNoDepth = 1.0F;  // what a table in float holds without a surface, in no other place here

CubeGnomonic cells(std::size_t n) { return CubeGnomonic::with_precision(90.0 / static_cast<double>(n)); }

template <class Value>
PackedTable<CubeGnomonic, Value> filled(const TriangleMesh& mesh, const CubeFill& fill) {
  PackedTable<CubeGnomonic, Value> table;
  fill_cube(mesh, fill, table);
  return table;
}

std::size_t marked(const PackedTable<CubeGnomonic, float>& table) {
  std::size_t count = 0;
  for (const std::uint32_t word : table.none) count += static_cast<std::size_t>(std::popcount(word));
  return count;
}

void expect_numbers(const CubeFill& fill, const TriangleMesh& mesh, std::span<const double> exact) {
  const auto floats = filled<float>(mesh, fill);
  const auto codes = filled<std::uint16_t>(mesh, fill);
  ASSERT_EQ(floats.values.size(), exact.size());
  ASSERT_EQ(codes.values.size(), exact.size());
  for (std::size_t e = 0; e < exact.size(); ++e) {
    ASSERT_EQ(floats.values[e] == kNoDepth, std::isnan(exact[e])) << "entry " << e;
    if (std::isnan(exact[e])) continue;
    const double lost = 41.0 * kFloatUlp * exact[e];
    ASSERT_NEAR(static_cast<double>(floats.values[e]), exact[e], lost) << "entry " << e;
    ASSERT_NEAR(codes.smallest + codes.step * codes.values[e], exact[e], 0.51 * codes.step + lost)
        << "entry " << e;
  }
}

void expect_as_exact(const TriangleMesh& mesh, std::size_t n, Layer layer) {
  const CubeFill fill{cells(n), layer, 1};
  const auto radii = fill_exact(mesh, fill.scheme, layer);
  const InverseDepthTable<CubeGnomonic> exact(radii);
  expect_numbers(fill, mesh, exact.values());
  const auto none = packed_table<float>(radii).none;
  EXPECT_EQ(filled<float>(mesh, fill).none, none);
  EXPECT_EQ(filled<std::uint16_t>(mesh, fill).none, none);
}

// Poles and meridians of the pair lie on entries and grid lines; 63 and 64 cells end a tile.
TEST(CubeFill, GeneratedJoint) {
  const BallSocketPair pair = make_ball_socket_pair(1000);
  for (const std::size_t n : {1U, 2U, 7U, 62U, 63U, 64U, 90U}) {
    expect_as_exact(pair.ball, n, Layer::farthest);
    expect_as_exact(pair.socket, n, Layer::nearest);
  }
  expect_as_exact(test::askew(pair.ball), 64, Layer::farthest);
  expect_as_exact(test::askew(pair.socket), 64, Layer::nearest);
}

// Faces of a quarter of the sphere, with corners in the middle of the cube's faces, and beside them.
TEST(CubeFill, FacesThatSpanTheCube) {
  expect_as_exact(octahedron(20.0), 33, Layer::farthest);
  expect_as_exact(octahedron(20.0), 64, Layer::farthest);
  expect_as_exact(test::askew(octahedron(20.0)), 40, Layer::farthest);
  expect_as_exact(test::askew(cone()), 40, Layer::farthest);
}

TEST(CubeFill, OffCentreBody) {
  expect_as_exact(sphere(22.0, 500, {15.0, 5.0, -8.0}), 70, Layer::farthest);
  expect_as_exact(sphere(22.0, 500, {30.0, 5.0, -8.0}), 70, Layer::nearest);  // the centre is outside
}

TEST(CubeFill, LayersOfAThickSocket) {
  const TriangleMesh wall = test::joined(cup(26.0, 70.0, 600), test::inside_out(cup(29.0, 75.0, 600)));
  expect_as_exact(wall, 64, Layer::nearest);
  expect_as_exact(wall, 64, Layer::farthest);
}

// The edges of a plate run along grid lines, of which the cells on either side are its rim.
TEST(CubeFill, RimAlongGridLines) {
  TriangleMesh plate = octahedron(80.0);
  const auto first = static_cast<VertexIndex>(plate.vertices.size());
  plate.vertices.insert(plate.vertices.end(), {{-10, -10, 20}, {10, -10, 20}, {10, 10, 20}, {-10, 10, 20}});
  plate.faces.insert(plate.faces.end(), {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
  expect_as_exact(plate, 16, Layer::nearest);
  const auto table = filled<float>(plate, {cells(16), Layer::nearest, 1});
  EXPECT_GE(marked(table), 2U * 4U * 8U - 4U);  // both sides of 8 cells an edge, those in corners once
}

TEST(CubeFill, SoupOfSteepAndThinFaces) {
  for (const unsigned seed : {1U, 2U}) {
    const TriangleMesh mesh = test::soup(30, seed);
    const CubeFill fill{cells(24), Layer::nearest, 1};
    const auto radii = fill_exact(mesh, fill.scheme, Layer::nearest);
    const InverseDepthTable<CubeGnomonic> exact(radii);
    expect_numbers(fill, mesh, exact.values());
    const auto none = filled<float>(mesh, fill).none;
    const auto expected = packed_table<float>(radii).none;
    ASSERT_EQ(none.size(), expected.size());
    for (std::size_t w = 0; w < none.size(); ++w) EXPECT_EQ(expected[w] & ~none[w], 0U);
  }
}

// Slivers down to a width of 1e-13 of their length, some across the edges of the cube, some through entries.
TEST(CubeFill, Slivers) {
  TriangleMesh mesh;
  for (const double width : {1e-1, 1e-4, 1e-8, 1e-13, 0.0}) {
    for (const Vec3& from : {Vec3(20, 1, 2), Vec3(2, 20, 1), Vec3(20, -20, 3), Vec3(-15, 0, 0)}) {
      const Vec3 along(-3.0, 7.0, 5.0);
      test::add_face(mesh, from, from + along, from + 0.5 * along + width * Vec3(1, 2, 3));
    }
  }
  const CubeFill fill{cells(200), Layer::farthest, 1};
  const InverseDepthTable<CubeGnomonic> exact(fill_exact(mesh, fill.scheme, fill.layer));
  expect_numbers(fill, mesh, exact.values());
}

// From near to far within a few cells, the far corner on an entry: the gradient in float would lose more
// there than the little that is left.
TEST(CubeFill, SteepFaces) {
  TriangleMesh mesh;
  for (const double far : {5.0, 50.0, 5e3, 5e5}) {
    const double z = std::round(std::log(far));
    test::add_face(mesh, {25.0, -3.0, z}, {25.0, 3.0, z}, far * Vec3(25.0, 0.0, z - 3.0));
  }
  const CubeFill fill{cells(200), Layer::farthest, 1};
  const InverseDepthTable<CubeGnomonic> exact(fill_exact(mesh, fill.scheme, fill.layer));
  expect_numbers(fill, mesh, exact.values());
}

TEST(CubeFill, NothingAtAll) {
  TriangleMesh mesh;
  expect_as_exact(mesh, 5, Layer::farthest);
  mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {1, 2, 3}}};  // both are seen edge-on
  expect_as_exact(mesh, 5, Layer::nearest);
}

// Powers of two change no digit.
TEST(CubeFill, UnitsDoNotMatter) {
  const TriangleMesh mesh = make_ball_socket_pair(300).socket;
  const CubeFill fill{cells(30), Layer::nearest, 1};
  const auto expected = filled<std::uint16_t>(mesh, fill);
  for (const double unit : {0x1p-60, 0x1p60}) {
    TriangleMesh scaled = mesh;
    for (Vec3& v : scaled.vertices) v *= unit;
    const auto table = filled<std::uint16_t>(scaled, fill);
    EXPECT_EQ(table.values, expected.values);
    EXPECT_EQ(table.none, expected.none);
    EXPECT_EQ(table.step * unit, expected.step);
  }
}

TEST(CubeFill, MemoryIsUsedAgain) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  const CubeFill fill{cells(40), Layer::nearest, 1};
  auto table = filled<float>(pair.socket, fill);
  EXPECT_GT(marked(table), 0U);
  const float* const place = table.values.data();
  fill_cube(pair.ball, fill, table);
  EXPECT_EQ(table.values.data(), place);
  EXPECT_EQ(table.values, filled<float>(pair.ball, fill).values);
  EXPECT_TRUE(table.none.empty());
}

TEST(CubeFill, BadInputIsRefused) {
  const TriangleMesh mesh = octahedron(20.0);
  PackedTable<CubeGnomonic, float> table;
  EXPECT_THROW(fill_cube(mesh, {cells(4), Layer::farthest, 0}, table), std::invalid_argument);
  EXPECT_THROW(fill_cube(mesh, {cells(7000), Layer::farthest, 1}, table), std::invalid_argument);
  EXPECT_THROW(fill_cube(octahedron(1e40), {cells(4), Layer::farthest, 1}, table), std::invalid_argument);
  EXPECT_THROW(fill_cube(octahedron(1e39), {cells(4), Layer::farthest, 1}, table), std::invalid_argument);
}

}  // namespace
}  // namespace impinge

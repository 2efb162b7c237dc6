// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: a table that is filled depends on its surface alone, bit for bit: not on the number of threads,
// the instruction set or the order of faces, and not on whether it was refilled after a part had moved
#include <algorithm>

#include <gtest/gtest.h>

#include "gap/simd/instruction_set.hpp"
#include "mesh/bodies.hpp"
#include "mesh/edges.hpp"
#include "mesh/generated_pair.hpp"
#include "table/fill/cube_fill.hpp"

namespace impinge {
namespace {

template <class Value>
PackedTable<CubeGnomonic, Value> full(const TriangleMesh& mesh, const CubeFill& fill) {
  PackedTable<CubeGnomonic, Value> table;
  fill_cube(mesh, fill, table);
  return table;
}

template <class Value>
void expect_same(const PackedTable<CubeGnomonic, Value>& a, const PackedTable<CubeGnomonic, Value>& b) {
  EXPECT_EQ(a.values, b.values);
  EXPECT_EQ(a.none, b.none);
  EXPECT_EQ(a.smallest, b.smallest);
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.divisions, b.divisions);
  EXPECT_EQ(a.stride, b.stride);
}

// A ball and a socket, the latter turned so that its rim crosses faces of the cube askew.
struct Filling {
  TriangleMesh mesh;
  CubeFill fill;
};
std::vector<Filling> fillings() {
  const BallSocketPair pair = make_ball_socket_pair(1000);
  const CubeGnomonic scheme = CubeGnomonic::with_precision(90.0 / 100.0);
  TriangleMesh socket = pair.socket;
  for (Vec3& v : socket.vertices) v = Eigen::AngleAxisd(0.4, Vec3(0.6, 0.0, 0.8)) * v;
  return {{pair.ball, {scheme, Layer::farthest, 1, {}}}, {socket, {scheme, Layer::nearest, 1, {}}}};
}

template <class Value>
void expect_same_with_every_set(const Filling& one) {
  const auto expected = full<Value>(one.mesh, one.fill);
  for (const std::string& set : instruction_sets()) {
    use_instruction_set(set);
    expect_same(full<Value>(one.mesh, one.fill), expected);
  }
  use_best_instruction_set();
}

TEST(CubeFillBits, EveryInstructionSet) {
  for (const Filling& one : fillings()) {
    expect_same_with_every_set<float>(one);
    expect_same_with_every_set<std::uint16_t>(one);
  }
}

TEST(CubeFillBits, AnyNumberOfThreads) {
  for (Filling& one : fillings()) {
    const auto expected = full<std::uint16_t>(one.mesh, one.fill);
    for (const int threads : {2, 3, 7}) {
      one.fill.threads = threads;
      expect_same(full<std::uint16_t>(one.mesh, one.fill), expected);
    }
  }
}

TEST(CubeFillBits, AnyOrderOfFaces) {
  for (Filling& one : fillings()) {
    const auto expected = full<std::uint16_t>(one.mesh, one.fill);
    std::ranges::reverse(one.mesh.faces);
    expect_same(full<std::uint16_t>(one.mesh, one.fill), expected);
  }
}

TriangleMesh pushed(TriangleMesh mesh, const Vec3& direction, double share) {
  for (Vec3& v : mesh.vertices) {
    const double off = angle_between(v, direction) / (12.0 * kDegree);
    if (off < 1.0) v *= 1.0 + share * (1.0 - off);
  }
  return mesh;
}

// Returns the share of the entries that was worked out.
template <class Value>
double expect_refilled(const TriangleMesh& before, const TriangleMesh& after, const CubeFill& fill) {
  auto table = full<Value>(before, fill);
  const std::size_t worked_out = refill_cube(before, after, fill, table);
  expect_same(table, full<Value>(after, fill));
  return static_cast<double>(worked_out) / static_cast<double>(table.values.size());
}

// Directions in the middle of a face of the cube, at an edge and at a corner of it, and at the rim.
TEST(CubeFillBits, RefillAfterAPartHasMoved) {
  for (Filling& one : fillings()) {
    one.fill.scheme = CubeGnomonic::with_precision(90.0 / 300.0);
    one.fill.room = {0.01, 0.12};
    for (const Vec3& direction : {Vec3(0.1, 0.2, 1.0), Vec3(1, 0, 1), Vec3(1, -1, 1), Vec3(0.9, 0.1, 0.05)}) {
      const TriangleMesh after = pushed(one.mesh, direction, 0.05);
      EXPECT_LT(expect_refilled<std::uint16_t>(one.mesh, after, one.fill), 0.25);
      EXPECT_LT(expect_refilled<float>(one.mesh, after, one.fill), 0.25);
    }
  }
}

// Single corners of a rim whose faces are a third of a cell wide: a change shows in cells that no entry of
// the face is in, some of them beyond the edge of a tile.
TEST(CubeFillBits, RefillAfterTheRimHasMoved) {
  const CubeFill fill{CubeGnomonic::with_precision(90.0 / 63.0), Layer::nearest, 1, {0.01, 0.12}};
  TriangleMesh before = cup(26.0, 12.0, 4000);
  for (Vec3& v : before.vertices) v = Eigen::AngleAxisd(0.1, Vec3(0.6, 0.8, 0.0)) * v;
  const std::vector<Edge> rim = boundary_edges(before);
  for (std::size_t k = 0; k < rim.size(); k += 3) {
    TriangleMesh after = before;
    Vec3& corner = after.vertices[rim[k][0]];
    corner += (k % 2 == 0 ? 0.2 : -0.2) * corner.cross(before.vertices[rim[k][1]]).cross(corner).normalized();
    corner += (k % 4 < 2 ? 0.3 : -0.3) * corner.cross(before.vertices[rim[k][1]]).normalized();
    expect_refilled<std::uint16_t>(before, after, fill);
  }
}

// A wider range of numbers takes other steps: everything is worked out again.
TEST(CubeFillBits, RefillBeyondTheRange) {
  const Filling ball = fillings().front();
  const TriangleMesh after = pushed(ball.mesh, {0.1, 0.2, 1.0}, 0.5);
  EXPECT_EQ(expect_refilled<std::uint16_t>(ball.mesh, after, ball.fill), 1.0);
  EXPECT_LT(expect_refilled<float>(ball.mesh, after, ball.fill), 0.25);
}

TEST(CubeFillBits, NothingMovedIsNothingToDo) {
  const Filling ball = fillings().front();
  EXPECT_EQ(expect_refilled<float>(ball.mesh, ball.mesh, ball.fill), 0.0);
}

TEST(CubeFillBits, OtherMeshesAndTablesAreRefused) {
  const Filling ball = fillings().front();
  auto table = full<float>(ball.mesh, ball.fill);
  EXPECT_THROW(refill_cube(ball.mesh, make_ball_socket_pair(300).ball, ball.fill, table),
               std::invalid_argument);
  CubeFill finer = ball.fill;
  finer.scheme = CubeGnomonic::with_precision(0.5);
  EXPECT_THROW(refill_cube(ball.mesh, ball.mesh, finer, table), std::invalid_argument);
}

}  // namespace
}  // namespace impinge

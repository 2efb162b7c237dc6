// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: a table that is filled depends on its surface alone, bit for bit: not on the number of threads,
// the instruction set or the order of faces.
#include <algorithm>

#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"
#include "methods/instruction_set.hpp"
#include "support/turned.hpp"
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
  const TriangleMesh socket = test::turned(pair.socket, 0.4, Vec3(0.6, 0.0, 0.8));
  return {{pair.ball, {scheme, Layer::farthest, 1}}, {socket, {scheme, Layer::nearest, 1}}};
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

}  // namespace
}  // namespace impinge

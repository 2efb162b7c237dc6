// SPDX-License-Identifier: GPL-3.0-or-later
// A table brought up to date where its mesh has moved is the table of the new mesh, bit for bit.
#include "methods/local_refill.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"
#include "sphere/schemes/icosahedral_gnomonic.hpp"
#include "sphere/schemes/rsid.hpp"

namespace impinge {
namespace {

TriangleMesh pushed(TriangleMesh mesh, const Vec3& direction, double width) {
  for (Vec3& v : mesh.vertices) {
    const double off = angle_between(v, direction) / width;
    if (off < 1.0) v *= 1.0 - 0.05 * (1.0 - off);
  }
  return mesh;
}

template <class S>
std::size_t expect_same(const TriangleMesh& before, const TriangleMesh& after, Layer layer) {
  const S scheme = S::with_precision(2.0);
  const RadialTable<S> expected = fill_exact(after, scheme, layer);
  RadialTable<S> table = fill_exact(before, scheme, layer);
  const std::size_t worked_out = refill(before, after, layer, table);
  for (std::size_t i = 0; i < scheme.size(); ++i) {
    const double a = table.radii()[i];
    const double b = expected.radii()[i];
    EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << "entry " << i;
  }
  for (std::size_t c = 0; c < scheme.cells(); ++c) EXPECT_EQ(table.is_rim_cell(c), expected.is_rim_cell(c));
  return worked_out;
}

TEST(LocalRefill, AClosedBallPushedInAtOnePlace) {
  const TriangleMesh ball = make_ball_socket_pair(1000).ball;
  const TriangleMesh after = pushed(ball, Vec3(0.5, 0.3, 0.7), 12.0 * kDegree);
  const std::size_t worked_out = expect_same<Rsid>(ball, after, Layer::farthest);
  EXPECT_GT(worked_out, 0U);
  EXPECT_LT(worked_out, Rsid::with_precision(2.0).size() / 10);
  expect_same<IcosahedralGnomonic>(ball, after, Layer::farthest);
}

TEST(LocalRefill, TheRimOfASocketMoves) {
  const TriangleMesh socket = make_ball_socket_pair(1000).socket;
  TriangleMesh after = socket;
  for (Vec3& v : after.vertices) {
    if (angle_between(v, Vec3::UnitX()) < 15.0 * kDegree)
      v += Vec3(0.0, 0.0, 1.5);  // the rim is at 87 degrees
  }
  ASSERT_NE(after.vertices, socket.vertices);
  EXPECT_GT(expect_same<Rsid>(socket, after, Layer::nearest), 0U);
}

TEST(LocalRefill, NothingMovedIsNothingToDo) {
  const TriangleMesh ball = make_ball_socket_pair(200).ball;
  EXPECT_EQ(expect_same<Rsid>(ball, ball, Layer::farthest), 0U);
}

TEST(LocalRefill, AnotherMeshIsRefused) {
  const TriangleMesh ball = make_ball_socket_pair(200).ball;
  RadialTable<Rsid> table = fill_exact(ball, Rsid::with_precision(5.0), Layer::farthest);
  EXPECT_THROW(refill(ball, make_ball_socket_pair(202).ball, Layer::farthest, table), std::invalid_argument);
}

}  // namespace
}  // namespace impinge

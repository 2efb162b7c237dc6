// SPDX-License-Identifier: GPL-3.0-or-later
// fill_exact() = fill_pairwise() at every entry, for every scheme: the same entries have a surface, and the
// radii agree within 1e-9 r (they differ by rounding only; 1e-12 r is what is met).
#include "table/exact_raster.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "support/every_scheme.hpp"
#include "support/joined.hpp"
#include "support/random_cases.hpp"
#include "support/turned.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

constexpr double kRelative = 1e-9;

// Of the gate's optimised build on; coarser where sanitizers make brute force ten times slower.
double fine() { return random_cases() >= 10'000 ? 1.0 : 2.0; }

void expect_same_everywhere(const TriangleMesh& mesh, double precision, Layer layer) {
  test::every_scheme([&]<class S>() {
    const S scheme = S::with_precision(precision);
    const auto oracle = fill_pairwise(mesh, scheme, layer);
    const auto table = fill_exact(mesh, scheme, layer);
    for (std::size_t i = 0; i < scheme.size(); ++i) {
      const double expected = oracle.radii()[i];
      const double found = table.radii()[i];
      ASSERT_EQ(std::isnan(found), std::isnan(expected)) << S::name << " entry " << i;
      if (!std::isnan(expected)) {
        ASSERT_NEAR(found, expected, kRelative * expected) << S::name << " entry " << i;
      }
    }
    for (std::size_t cell = 0; cell < scheme.cells(); ++cell) {
      ASSERT_EQ(table.is_rim_cell(cell), oracle.is_rim_cell(cell));
    }
  });
}

Eigen::Matrix3d some_rotation() {
  return (Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())).toRotationMatrix();
}

// Edges along phi = 90 degrees and theta = 0, 90, 180, 270, that is on grid lines; corners on entries, the
// poles among them.
TEST(ExactRaster, EdgesOnGridLinesAndCornersOnEntries) {
  expect_same_everywhere(octahedron(20.0), 1.0, Layer::farthest);
  expect_same_everywhere(octahedron(20.0), 7.5, Layer::farthest);
}

TEST(ExactRaster, PoleInsideAFace) {
  expect_same_everywhere(test::turned(octahedron(20.0), some_rotation()), 2.0, Layer::farthest);
}

TEST(ExactRaster, PoleOnAnEdge) {
  const Eigen::Matrix3d eighth = Eigen::AngleAxisd(kPi / 4.0, Vec3::UnitX()).toRotationMatrix();
  TriangleMesh mesh = test::turned(octahedron(20.0), eighth);
  for (Vec3& v : mesh.vertices) {
    if (std::abs(v.x()) < 1e-12) v.x() = 0.0;  // the edges over the poles lie in the plane x = 0 exactly
  }
  expect_same_everywhere(mesh, 2.0, Layer::farthest);
}

TEST(ExactRaster, GeneratedJoint) {
  const BallSocketPair pair = make_ball_socket_pair(1000);
  expect_same_everywhere(pair.ball, fine(), Layer::farthest);
  expect_same_everywhere(pair.socket, fine(), Layer::nearest);
  expect_same_everywhere(test::turned(pair.socket, some_rotation()), fine(), Layer::nearest);
}

TEST(ExactRaster, OffCentreBodyAndCone) {
  expect_same_everywhere(sphere(22.0, 500, {15.0, 5.0, -8.0}), 2.0, Layer::farthest);
  expect_same_everywhere(cone(), 2.0, Layer::farthest);
}

TEST(ExactRaster, LayersOfAThickSocket) {
  const TriangleMesh wall = test::joined(cup(26.0, 70.0, 600), test::inside_out(cup(29.0, 75.0, 600)));
  expect_same_everywhere(wall, fine(), Layer::nearest);
  expect_same_everywhere(wall, fine(), Layer::farthest);
}

}  // namespace
}  // namespace impinge

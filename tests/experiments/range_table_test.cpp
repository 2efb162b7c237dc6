// SPDX-License-Identifier: GPL-3.0-or-later
// low <= radius along u <= high, for every direction u and every layer of the mesh; no surface along u where
// the cover is `none`, and one where it is `whole`.
#include "10_certified/range_table.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "support/dice.hpp"
#include "support/directions.hpp"
#include "support/every_scheme.hpp"
#include "support/joined.hpp"
#include "support/random_cases.hpp"
#include "support/turned.hpp"
#include "table/pairwise.hpp"

namespace impinge::lab {
namespace {

struct Truth {
  Vec3 direction;
  double nearest;  // NaN where there is no surface
  double farthest;
};

std::vector<Truth> truth_of(const TriangleMesh& mesh, std::size_t random) {
  const RayCaster rays(mesh);
  auto directions = test::random_directions(random, 60);
  for (const Vec3& u : test::feature_directions(mesh)) directions.push_back(u);
  for (const Vec3& x : test::special_directions()) directions.push_back(x.normalized());
  std::vector<Truth> truths;
  truths.reserve(directions.size());
  for (const Vec3& u : directions)
    truths.push_back({u, rays.cast(u, Layer::nearest), rays.cast(u, Layer::farthest)});
  return truths;
}

struct Findings {
  std::size_t wrong = 0;
  std::size_t none = 0;
  std::size_t part = 0;
  std::size_t whole = 0;
  double mean_width = 0.0;  // mm, where the cover is whole
};

// `shrink` mm are taken from both ends of each range.
template <class S>
Findings examine(const std::vector<Truth>& truths, const RangeTable<S>& table, double shrink = 0.0) {
  Findings found;
  for (const Truth& truth : truths) {
    const SurfaceRange at = table.at(truth.direction);
    const bool met = !std::isnan(truth.nearest);
    const bool inside = truth.nearest >= at.range.low + shrink && truth.farthest <= at.range.high - shrink;
    const bool wrong = met ? at.cover == Cover::none || !inside : at.cover == Cover::whole;
    found.wrong += wrong ? 1U : 0U;
    ++(at.cover == Cover::none ? found.none : at.cover == Cover::part ? found.part : found.whole);
    if (at.cover == Cover::whole) found.mean_width += at.range.high - at.range.low;
  }
  found.mean_width /= static_cast<double>(std::max<std::size_t>(found.whole, 1));
  return found;
}

// Two spheres, one in the other: two layers everywhere.
TriangleMesh two_layers() {
  return test::joined(sphere(20.0, 60), test::askew(sphere(24.0, 100, {1.0, 0.0, 0.0})));
}

TEST(RangeTable, HoldsTheSurfaceWithEveryScheme) {
  const BallSocketPair pair = make_ball_socket_pair(100);
  for (const TriangleMesh& mesh : {pair.ball, test::askew(pair.socket)}) {
    const auto truths = truth_of(mesh, 300);
    test::every_scheme([&]<class S>() {
      for (const double precision : {10.0, 3.0}) {
        const auto found = examine(truths, fill_ranges(mesh, S::with_precision(precision)));
        EXPECT_EQ(found.wrong, 0U) << S::name << " at " << precision;
      }
    });
  }
}

TEST(RangeTable, HoldsTheSurfaceOfBodiesOfAllKinds) {
  const std::vector<TriangleMesh> meshes{make_ball_socket_pair(300).socket, test::askew(octahedron(20.0)),
                                         cone({.sides = 24}), two_layers(),
                                         sphere(22.0, 100, {12.0, 3.0, -9.0})};
  for (const TriangleMesh& mesh : meshes) {
    const auto truths = truth_of(mesh, 500);
    for (const double precision : {10.0, 2.0}) {
      EXPECT_EQ(examine(truths, fill_ranges(mesh, Rsid::with_precision(precision))).wrong, 0U) << precision;
      EXPECT_EQ(examine(truths, fill_ranges(mesh, Usid::with_precision(precision))).wrong, 0U) << precision;
    }
  }
}

TEST(RangeTable, SaysWhereTheSurfaceEnds) {
  const TriangleMesh socket = test::askew(cup(26.0, 80.0, 2000));
  const auto truths = truth_of(socket, 20000);
  const auto found = examine(truths, fill_ranges(socket, Rsid::with_precision(1.0)));
  EXPECT_EQ(found.wrong, 0U);
  const auto all = static_cast<double>(truths.size());
  EXPECT_GT(static_cast<double>(found.none), 0.25 * all);
  EXPECT_GT(static_cast<double>(found.whole), 0.4 * all);
  EXPECT_GT(found.part, 0U);
  EXPECT_LT(static_cast<double>(found.part), 0.15 * all);
}

// A range that is a little too narrow must be noticed.
TEST(RangeTable, ARangeThatIsTooNarrowIsCaught) {
  const TriangleMesh ball = make_ball_socket_pair(1000).ball;
  const auto truths = truth_of(ball, 20000);
  const auto table = fill_ranges(ball, CubeGnomonic::with_precision(1.0));
  EXPECT_EQ(examine(truths, table).wrong, 0U);
  EXPECT_GT(examine(truths, table, 0.01).wrong, 100U);
  EXPECT_GT(examine(truths, table, 1e-5).wrong, 10U);  // vertices and edges are touched
}

// The width is of first order in the spacing, so that halving the precision halves it.
TEST(RangeTable, NarrowsWithThePrecision) {
  const TriangleMesh ball = sphere(22.0, 2000, {3.0, 2.0, -4.0});
  const auto truths = truth_of(ball, 2000);
  double last = examine(truths, fill_ranges(ball, IcosahedralGnomonic::with_precision(2.0))).mean_width;
  for (const double precision : {1.0, 0.5}) {
    const auto found = examine(truths, fill_ranges(ball, IcosahedralGnomonic::with_precision(precision)));
    EXPECT_LT(found.mean_width, 0.6 * last);
    EXPECT_GT(found.mean_width, 0.4 * last);
    last = found.mean_width;
  }
}

// n.u = 1 / r on one large face: the range of a cap is known in closed form, r / cos of the incidence at its
// ends.
TEST(RangeTable, IsThatOfTheCapOnALargeFace) {
  const TriangleCone cone({-12, -12, 10}, {12, -12, 10}, {0, 18, 10});
  const FaceRange face(cone);
  for (const double psi : {0.0, 0.01, 0.3, 0.5}) {
    const double rho = 0.02;
    const auto part = face.in_cap({Vec3(std::sin(psi), 0.0, std::cos(psi)), rho});
    ASSERT_TRUE(part);
    EXPECT_NEAR(part->range.high, 10.0 / std::cos(psi + rho), 1e-6);
    EXPECT_NEAR(part->range.low, 10.0 / std::cos(std::max(0.0, psi - rho)), 1e-6);
    EXPECT_LE(part->range.low, 10.0 / std::cos(std::max(0.0, psi - rho)));
    EXPECT_GE(part->range.high, 10.0 / std::cos(psi + rho));
  }
  EXPECT_FALSE(face.in_cap({-Vec3::UnitZ(), 0.5}));
  const auto all = face.in_cap({-Vec3::UnitZ(), 2.5});  // too wide for the formulas: all of the face
  ASSERT_TRUE(all);
  EXPECT_NEAR(all->range.low, 10.0, 1e-6);
  EXPECT_NEAR(all->range.high, std::hypot(10.0, 18.0), 1e-6);
}

// A corner of a face in the very middle of a cap, both as small as they come.
TEST(RangeTableAttack, AFaceInASmallCapHasARange) {
  test::Dice dice(19);
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const Vec3 a = 20.0 * dice.direction();
    const double size = dice.power(-8.0, -2.0);
    const TriangleCone cone(a, a + size * dice.direction(), a + size * dice.direction());
    if (cone.edge_on()) continue;
    const double reach = dice.power(-10.0, -3.0);
    const Vec3 u = a.normalized();
    const DirectionCap cap{(u + 0.99 * reach * u.unitOrthogonal()).normalized(), reach};
    const auto part = FaceRange(cone).in_cap(cap);
    ASSERT_TRUE(part.has_value()) << size << ' ' << reach;
    ASSERT_LE(part->range.low, a.norm());
    ASSERT_GE(part->range.high, a.norm());
  }
}

}  // namespace
}  // namespace impinge::lab

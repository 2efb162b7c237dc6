// SPDX-License-Identifier: GPL-3.0-or-later
// With l <= y - Y <= h in a cell, y = 1 / depth of the surface and Y interpolated, a centred table errs by at
// most half of what the largest h and the least l of a cell and its neighbours are apart: half as much as the
// table it was made of where the surface bends one way, and nowhere more.
#include "methods/centred_table.hpp"

#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/error_range.hpp"
#include "support/bits.hpp"
#include "support/bound_probes.hpp"
#include "support/joined.hpp"
#include "table/own_scheme.hpp"
#include "table/pairwise.hpp"

namespace impinge::lab {
namespace {

// A surface, its table, and the same centred.
template <class S>
struct Centred {
  Centred(TriangleMesh surface, double precision_deg, Layer which)
      : mesh(std::move(surface)),
        layer(which),
        filled(fill_exact(mesh, S::with_precision(precision_deg), layer)),
        exact(filled),
        table(centred_table(mesh, filled, layer)) {}

  // Proven, and attained up to 1 %.
  TableBound bound(const InverseDepthTable<S>& of) const { return table_bound(mesh, of, layer, {1.01}); }

  TriangleMesh mesh;
  Layer layer;
  RadialTable<S> filled;
  InverseDepthTable<S> exact;
  InverseDepthTable<S> table;
};
using Gnomonic = Centred<CubeGnomonic>;
using Equiangular = Centred<CubeEquiangular>;

// What the largest error becomes: never larger in 1 / depth, here in mm, whose r^2 depth differs between two
// cells of these tables by a few percent.
template <class S>
double share_left(const Centred<S>& one) {
  return one.bound(one.table).bound_mm / one.bound(one.exact).attained_mm;
}

TEST(CentredTable, HalvesTheLargestErrorOfABall) {
  EXPECT_LT(share_left(Gnomonic(sphere(22.0, 300), 3.0, Layer::farthest)), 0.53);
}
TEST(CentredTable, HalvesTheLargestErrorOfASocket) {
  EXPECT_LT(share_left(Gnomonic(cup(26.0, 80.0, 200), 3.0, Layer::nearest)), 0.53);
}
TEST(CentredTable, HalvesItOnGridLinesAtEqualAngles) {
  EXPECT_LT(share_left(Equiangular(sphere(22.0, 300), 3.0, Layer::farthest)), 0.53);
}

TEST(CentredTable, ErrsLessWhereOneWayOfBendingPrevails) {
  EXPECT_LT(share_left(Gnomonic(make_ball_socket_pair(400).ball, 3.0, Layer::farthest)), 0.8);
}
TEST(CentredTable, ErrsNowhereMoreOnWaves) {
  const auto waves = [](const Vec3& u) { return 22.0 + 0.5 * std::sin(9.0 * (u.x() + u.y())); };
  EXPECT_LT(share_left(Gnomonic(radial_body(400, waves), 3.0, Layer::farthest)), 1.03);
}

// The bound of any table holds of it, and is tight.
TEST(CentredTable, HasABound) {
  const Gnomonic ball(make_ball_socket_pair(300).ball, 4.0, Layer::farthest);
  const TableBound bound = ball.bound(ball.table);
  const RayCaster oracle(ball.mesh);
  const auto error = [&](const Vec3& u) {
    const double found = std::abs(ball.table.radius_at(u) - oracle.cast(u, ball.layer));
    return std::isnan(found) ? 0.0 : found;
  };
  const auto probes = test::bound_probes(ball.mesh, ball.table.scheme(), 1500);
  const double largest = test::largest_error(error, probes, 0.5 * ball.table.scheme().stencil_radius());
  EXPECT_LE(largest, bound.bound_mm);
  EXPECT_GT(largest, 0.6 * bound.bound_mm);
}

constexpr double kD = 20.0;

// Two planes x + g |y| = d that meet at y = 0, up to |y| = width.
TriangleMesh roof(double width, double g = 0.3) {
  TriangleMesh mesh;
  for (const double y : {-width, 0.0, width})
    for (const double z : {-8.0, 8.0}) mesh.vertices.emplace_back(kD - g * std::abs(y), y, z);
  mesh.faces = {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}};
  return mesh;
}

// They meet in a line through the middle of a cell of width w = 2 / n: y = (1 + g |b|) / d is interpolated
// too high by e = g w / 2 d there, too low where g < 0. Half of it is taken from the entries beside the line,
// nothing from others.
void expect_half_of(double g) {
  constexpr std::size_t kCells = 9;  // the middle of the fifth is in the middle of the face
  const Gnomonic one(roof(8.0, g), 90.0 / kCells, Layer::nearest);
  const double e = g / (kCells * kD);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < one.table.values().size(); ++i) {
    const double before = one.exact.values()[i];
    if (std::isnan(before)) continue;
    const Vec3 u = one.table.scheme().direction(i);
    const double beside = std::abs(u.y() / u.x()) * kCells;
    const double change = one.table.values()[i] - before;
    if (change != 0.0 && beside < 1.5) ++moved;
    EXPECT_NEAR(change, beside < 1.5 && change != 0.0 ? -0.5 * e : 0.0, 1e-12) << u.transpose();
  }
  EXPECT_GE(moved, 4U);
  EXPECT_NEAR(one.exact.radius_at(Vec3::UnitX()), 1.0 / (1.0 / kD + e), 1e-12);
  EXPECT_NEAR(one.table.radius_at(Vec3::UnitX()), 1.0 / (1.0 / kD + 0.5 * e), 1e-9);
}

TEST(CentredTable, TakesHalfOfTheErrorOfARidge) { expect_half_of(0.3); }
TEST(CentredTable, AddsHalfOfTheErrorOfAValley) { expect_half_of(-0.3); }

// f(t) = (t - 1/4)^2 - 1/16 has its least value between the three places; a line its own at the ends.
TEST(CentredTable, KnowsTheRangeOfAQuadratic) {
  const auto f = [](double t) { return (t - 0.25) * (t - 0.25) - 0.0625; };
  const ErrorRange range = range_of_quadratic({f(0.0), f(0.5), f(1.0)});
  EXPECT_NEAR(range.low, -0.0625, 1e-15);
  EXPECT_EQ(range.high, f(1.0));
  const ErrorRange line = range_of_quadratic({-1.0, 0.0, 1.0});
  EXPECT_EQ(line.low, -1.0);
  EXPECT_EQ(line.high, 1.0);
}

// A wall has two sides, one of which the layer hides: its edges do not count.
TEST(CentredTable, IsThatOfTheLayer) {
  const TriangleMesh wall = test::joined(sphere(22.0, 300), sphere(25.0, 500));
  const Gnomonic both(wall, 5.0, Layer::nearest);
  const Gnomonic one(sphere(22.0, 300), 5.0, Layer::nearest);
  for (std::size_t i = 0; i < one.table.values().size(); ++i)
    EXPECT_EQ(both.table.values()[i], one.table.values()[i]);
}

// Where no cell answers, entries keep their numbers. Cells at the rim answer none as before.
TEST(CentredTable, LeavesTheRimAlone) {
  const TriangleMesh mesh = roof(8.0);
  auto filled = fill_exact(mesh, CubeGnomonic::with_precision(10.0), Layer::nearest);
  for (std::size_t cell = 0; cell < filled.scheme().cells(); ++cell) filled.mark_rim_cell(cell);
  const InverseDepthTable<CubeGnomonic> before(filled);
  const InverseDepthTable<CubeGnomonic> after(centred_table(mesh, filled, Layer::nearest));
  for (std::size_t i = 0; i < filled.radii().size(); ++i)
    EXPECT_EQ(test::bits(after.values()[i]), test::bits(before.values()[i]));
  const Gnomonic socket(cup(26.0, 60.0, 300), 5.0, Layer::nearest);
  for (const Vec3& u : test::bound_probes(socket.mesh, socket.table.scheme(), 1000))
    EXPECT_EQ(std::isnan(socket.table.radius_at(u)), std::isnan(socket.exact.radius_at(u)));
}

// Entries that stand in one direction hold one number, so that there is no crack along the edges of the cube.
TEST(CentredTable, HasNoCracks) {
  const Gnomonic ball(make_ball_socket_pair(300).ball, 5.0, Layer::farthest);
  std::map<std::tuple<double, double, double>, double> known;
  std::size_t again = 0;
  for (std::size_t i = 0; i < ball.table.values().size(); ++i) {
    const Vec3 u = ball.table.scheme().direction(i);
    const auto [place, first] = known.try_emplace({u.x(), u.y(), u.z()}, ball.table.values()[i]);
    again += first ? 0U : 1U;
    EXPECT_EQ(place->second, ball.table.values()[i]);
  }
  EXPECT_EQ(again, 6U * 19 * 19 - (6U * 18 * 18 + 2));
}

// Where cells are far too large the errors are as large as the numbers, none of which turns negative.
TEST(CentredTable, KeepsItsNumbersPositive) {
  for (const double precision : {90.0, 45.0, 30.0}) {
    const Gnomonic aside(sphere(22.0, 400, {15.0, 9.0, -12.0}), precision, Layer::farthest);
    for (std::size_t i = 0; i < aside.table.values().size(); ++i)
      EXPECT_GE(aside.table.values()[i], 0.49 * aside.exact.values()[i]);
  }
}

}  // namespace
}  // namespace impinge::lab

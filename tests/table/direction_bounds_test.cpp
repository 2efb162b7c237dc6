// SPDX-License-Identifier: GPL-3.0-or-later
// |table.radius_at(u) - radius of the mesh along u| <= at(u) <= everywhere(), and for tables of radii
// at(u) <= error_bound_at(u), wherever the table has a surface. Every scheme: scheme_bounds_test.cpp.
#include "table/direction_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "support/directions.hpp"
#include "support/turned.hpp"
#include "table/exact_raster.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

constexpr double kOfOracle = 1e-11;  // mm, rounding of the rays and the table
constexpr double kSpacing = 4.0;     // degrees

// All bounds of the directions that have a surface, sorted. Fails where one of them does not hold.
template <class Table, class Bounds>
std::vector<double> bounds_that_hold(const TriangleMesh& mesh, const Table& table, const Bounds& bounds) {
  const RayCaster oracle(mesh);
  auto directions = test::random_directions(300, 41);
  for (const Vec3& u : test::feature_directions(mesh)) directions.push_back(u);
  std::vector<double> found;
  for (const Vec3& u : directions) {
    const double radius = table.radius_at(u);
    const double bound = bounds.at(u);
    EXPECT_EQ(std::isnan(radius), std::isnan(bound));
    if (std::isnan(radius)) continue;
    EXPECT_LE(std::abs(radius - oracle.cast(u, Layer::farthest)), bound + kOfOracle) << u.transpose();
    EXPECT_LE(bound, bounds.everywhere());
    found.push_back(bound);
  }
  std::ranges::sort(found);
  return found;
}

template <class S>
std::vector<double> of_radii(const TriangleMesh& mesh) {
  const auto table = fill_exact(mesh, S::with_precision(kSpacing), Layer::farthest);
  const DirectionBounds bounds(mesh, table, Layer::farthest);
  const auto slopes = largest_slopes(mesh, table.scheme());
  for (const Vec3& u : test::random_directions(300, 42)) {
    const double first_order = error_bound_at(table, slopes, u);
    EXPECT_TRUE(std::isnan(first_order) || bounds.at(u) <= first_order);
  }
  return bounds_that_hold(mesh, table, bounds);
}

std::vector<double> of_inverse_depths(const TriangleMesh& mesh) {
  const InverseDepthTable<CubeGnomonic> table(
      fill_exact(mesh, CubeGnomonic::with_precision(kSpacing), Layer::farthest));
  return bounds_that_hold(mesh, table, FlatDirectionBounds(mesh, table, Layer::farthest));
}

double median(const std::vector<double>& sorted) { return sorted.at(sorted.size() / 2); }

TEST(DirectionBounds, HoldInEveryDirectionForBothInterpolants) {
  for (const TriangleMesh& mesh : {make_ball_socket_pair(100).ball, test::askew(cone())}) {
    of_radii<CubeGnomonic>(mesh);
    of_inverse_depths(mesh);
  }
}

TEST(DirectionBounds, ACellThatTheSearchHasNotMetSaysNothing) {
  EXPECT_EQ(bound_in({0.0F, 0.5F}, 0, 2.0), 2.0);
  EXPECT_EQ(bound_in({0.0F, 0.5F}, 1, 2.0), 0.5);
  EXPECT_EQ(bound_in({0.0F, 0.5F}, 1, 0.25), 0.25);
}

// Inverse depths are exact on the eight flat faces; only cells that an edge crosses have a bound at all.
TEST(DirectionBounds, AreThoseOfTheCellAndNotOfTheWorstOne) {
  const std::vector<double> flat = of_inverse_depths(test::askew(octahedron(20.0)));
  EXPECT_LT(median(flat), 1e-7);
  EXPECT_GT(flat.back(), 0.1);
  const std::vector<double> smooth = of_radii<CubeGnomonic>(test::askew(octahedron(20.0)));
  EXPECT_LT(median(smooth), 0.1 * smooth.back());
  EXPECT_GT(median(smooth), 1e-6);
}

}  // namespace
}  // namespace impinge

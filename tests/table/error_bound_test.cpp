// SPDX-License-Identifier: GPL-3.0-or-later
// |table.radius_at(u) - radius of the mesh along u| <= error_bound_at(u), wherever the table has a surface.
#include "table/error_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "support/directions.hpp"
#include "support/every_scheme.hpp"
#include "support/joined.hpp"
#include "support/turned.hpp"
#include "table/direction_bounds.hpp"
#include "table/exact_raster.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

constexpr double kRounding = 1e-11;  // mm, of the oracle and the table

// A surface with the radii of all its triangles, found once for all schemes.
struct Probed {
  TriangleMesh mesh;
  Layer layer = Layer::farthest;
  std::vector<Vec3> directions;
  std::vector<double> truth;  // mm
};

Probed probed(TriangleMesh mesh, Layer layer = Layer::farthest) {
  Probed made{std::move(mesh), layer, test::random_directions(5000, 40), {}};
  for (const Vec3& u : test::feature_directions(made.mesh)) made.directions.push_back(u);
  const RayCaster oracle(made.mesh);
  for (const Vec3& u : made.directions) made.truth.push_back(oracle.cast(u, layer));
  return made;
}

struct Tightness {
  double worst_share = 0.0;  // largest error as a share of its bound
  bool bounded = false;      // most bounds are finite: they say something
};

template <class S>
Tightness measure(const Probed& surface, const S& scheme) {
  const auto table = fill_exact(surface.mesh, scheme, surface.layer);
  const auto slopes = largest_slopes(surface.mesh, scheme);
  Tightness found;
  std::size_t finite = 0;
  for (std::size_t k = 0; k < surface.directions.size(); ++k) {
    const Vec3& u = surface.directions[k];
    const double radius = table.radius_at(u);
    const double bound = error_bound_at(table, slopes, u);
    EXPECT_EQ(std::isnan(radius), std::isnan(bound));
    if (std::isnan(radius)) continue;
    const double error = std::abs(radius - surface.truth[k]);
    EXPECT_LE(error, bound + kRounding) << S::name << " at " << u.transpose();
    finite += std::isfinite(bound) ? 1U : 0U;
    if (bound > 0.0) found.worst_share = std::max(found.worst_share, error / bound);
  }
  found.bounded = 2 * finite > surface.directions.size();
  return found;
}

template <class S>
void expect_bounds(const std::array<Probed, 4>& bodies, const Probed& socket, double precision) {
  const S scheme = S::with_precision(precision);
  SCOPED_TRACE(std::string(S::name) + " at " + std::to_string(precision));
  for (const Probed& body : bodies) {
    const Tightness found = measure(body, scheme);
    // A scheme that is sparse somewhere, as the conchoid at its south pole, has a wide bound everywhere.
    EXPECT_TRUE(found.bounded || scheme.stencil_radius() > 10.0 * kDegree);
    if (!found.bounded) continue;
    EXPECT_GT(found.worst_share, 0.02) << "the bound says nothing";
  }
  measure(socket, scheme);
}

TEST(TheoremSlope, HoldsOnBodiesOfAllKinds) {
  const BallSocketPair pair = make_ball_socket_pair(1000);
  // Its edges do not lie on grid lines, where the error is zero.
  const TriangleMesh tilted = test::askew(octahedron(20.0));
  const std::array bodies{probed(pair.ball), probed(tilted), probed(cone()),
                          probed(sphere(22.0, 300, {12.0, 3.0, -9.0}))};
  const Probed socket = probed(pair.socket, Layer::nearest);
  test::every_scheme([&]<class S>() {
    for (const double precision : {10.0, 3.0, 1.0}) expect_bounds<S>(bodies, socket, precision);
  });
}

TEST(ErrorBound, FallsWithThePrecision) {
  const TriangleMesh ball = make_ball_socket_pair(1000).ball;
  const std::vector<Vec3> directions = test::random_directions(1000, 41);
  test::every_scheme([&]<class S>() {
    double last = HUGE_VAL;
    for (const double precision : {3.0, 1.5, 0.75}) {
      const S scheme = S::with_precision(precision);
      const auto table = fill_exact(ball, scheme, Layer::farthest);
      const auto slopes = largest_slopes(ball, scheme);
      double largest = 0.0;
      for (const Vec3& u : directions) largest = std::max(largest, error_bound_at(table, slopes, u));
      EXPECT_LT(largest, 0.6 * last) << S::name << " at " << precision;
      last = largest;
    }
  });
}

TEST(ErrorBound, IsInfiniteNearAnEdgeOnFace) {
  TriangleMesh mesh = sphere(22.0, 500);
  test::add_face(mesh, {25, 0, 0}, {30, 0, 0}, {27, 1, 0});
  const Rsid scheme = Rsid::with_precision(2.0);
  const auto slopes = largest_slopes(mesh, scheme);
  const auto table = fill_exact(mesh, scheme, Layer::farthest);
  EXPECT_LT(error_bound_at(table, slopes, {-1.0, 0.1, 0.2}), 1.0);
  const auto near_face = scheme.stencil({27.0, 0.3, 0.0});
  EXPECT_TRUE(std::isinf(slopes[near_face.entry[0]]));
}

// The contract of DirectionBounds for every scheme, coarse and without halving. Compiled in one batch with
// table_bound_test.cpp it costs 2 s more, and 40 s without it:
//   |table.radius_at(u) - radius of the mesh along u| <= at(u) <= everywhere(), at(u) <= error_bound_at(u)

constexpr double kOfRays = 1e-11;  // mm, rounding of the rays and the table

TriangleMesh slanted_cone() { return test::askew(cone({.sides = 12})); }

// Entries and what is between them and the other taps of a cell that they are in: insides of cells, their
// borders and seams; poles and the seam itself, features of the mesh, and some at random.
template <class S>
std::vector<Vec3> chosen_directions(const TriangleMesh& mesh, const S& scheme) {
  std::vector<Vec3> chosen = test::random_directions(100, 41);
  for (const Vec3& u : test::feature_directions(mesh)) chosen.push_back(u);
  for (const Vec3& x : test::special_directions()) chosen.push_back(x.normalized());
  const double aside = 0.3 * scheme.stencil_radius();
  const std::size_t step = scheme.size() / 60 + 1;
  for (std::size_t i = 0; i < scheme.size(); i += step) {
    const Vec3 entry = scheme.direction(i);
    chosen.push_back(entry);
    const Stencil stencil = scheme.stencil(entry + aside * entry.unitOrthogonal());
    for (std::size_t k = 0; k < stencil.taps; ++k)
      chosen.push_back((entry + scheme.direction(stencil.entry[k])).normalized());
  }
  return chosen;
}

// Largest error as a share of its bound; fails where a bound does not hold.
template <class S>
double largest_share_of_bounds(const TriangleMesh& mesh, const S& scheme) {
  const RayCaster oracle(mesh);
  const auto table = fill_exact(mesh, scheme, Layer::farthest);
  const DirectionBounds bounds(mesh, table, Layer::farthest, {.budget = 0});
  const auto slopes = largest_slopes(mesh, scheme);
  double largest = 0.0;
  for (const Vec3& u : chosen_directions(mesh, scheme)) {
    const double radius = table.radius_at(u);
    const double bound = bounds.at(u);
    EXPECT_EQ(std::isnan(radius), std::isnan(bound)) << u.transpose();
    if (std::isnan(radius)) continue;
    const double error = std::abs(radius - oracle.cast(u, Layer::farthest));
    EXPECT_LE(error, bound + kOfRays) << u.transpose();
    EXPECT_LE(bound, std::min(bounds.everywhere(), error_bound_at(table, slopes, u)));
    if (error > kOfRays) largest = std::max(largest, error / bound);
  }
  return largest;
}

TEST(TheoremSlope, OfDirectionsHoldAndSayMuch) {
  const TriangleMesh mesh = slanted_cone();
  test::every_scheme([&]<class S>() {
    SCOPED_TRACE(S::name);
    const double share = largest_share_of_bounds(mesh, S::with_precision(9.0));
    EXPECT_GT(share, HasPatches<S> ? 0.3 : 0.02);
  });
}

// |table.radius_at(u) - radius of the mesh along u| <= at(u) <= everywhere(), and for tables of radii
// at(u) <= error_bound_at(u), wherever the table has a surface. Every scheme: above.

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

TEST(TheoremTable, HoldInEveryDirectionForBothInterpolants) {
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

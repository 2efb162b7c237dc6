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
#include "support/directions.hpp"
#include "support/every_scheme.hpp"
#include "support/joined.hpp"
#include "support/turned.hpp"
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

TEST(ErrorBound, HoldsOnBodiesOfAllKinds) {
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

}  // namespace
}  // namespace impinge

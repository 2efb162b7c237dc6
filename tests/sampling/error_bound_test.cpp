// SPDX-License-Identifier: GPL-3.0-or-later
// |table.radius_at(u) - radius of the mesh along u| <= error_bound_at(u), wherever the table has a surface.
#include "sampling/error_bound.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/ball_socket_pair.hpp"
#include "mesh/bodies.hpp"
#include "sampling/exact_raster.hpp"
#include "sampling/pairwise.hpp"
#include "sphere/scheme_list.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

constexpr double kRounding = 1e-11;  // mm, of the oracle and the table

struct Tightness {
  double worst = 0.0;        // largest error, mm
  double worst_share = 0.0;  // largest error as a share of its bound
  bool bounded = false;      // most bounds are finite: they say something
};

template <class S>
Tightness measure(const TriangleMesh& mesh, double precision, Layer layer) {
  const S scheme = S::with_precision(precision);
  const auto table = fill_exact(mesh, scheme, layer);
  const auto slopes = largest_slopes(mesh, scheme);
  const RayCaster oracle(mesh);
  auto directions = test::random_directions(5000, 40);
  for (const Vec3& u : test::feature_directions(mesh)) directions.push_back(u);
  Tightness found;
  std::size_t finite = 0;
  for (const Vec3& u : directions) {
    const double radius = table.radius_at(u);
    const double bound = error_bound_at(table, slopes, u);
    EXPECT_EQ(std::isnan(radius), std::isnan(bound));
    if (std::isnan(radius)) continue;
    const double error = std::abs(radius - oracle.cast(u, layer));
    EXPECT_LE(error, bound + kRounding) << S::name << " at " << u.transpose();
    found.worst = std::max(found.worst, error);
    finite += std::isfinite(bound) ? 1U : 0U;
    if (bound > 0.0) found.worst_share = std::max(found.worst_share, error / bound);
  }
  found.bounded = 2 * finite > directions.size();
  return found;
}

TEST(ErrorBound, HoldsOnBodiesOfAllKinds) {
  const BallSocketPair pair = make_ball_socket_pair(1000);
  TriangleMesh tilted =
      octahedron(20.0);  // so that its edges do not lie on grid lines, where the error is zero
  for (Vec3& v : tilted.vertices) v = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()) * v;
  for_each_scheme([&]<class S>() {
    for (const double precision : {10.0, 2.0, 0.5}) {
      for (const TriangleMesh& mesh : {pair.ball, tilted, cone(), sphere(22.0, 300, {12.0, 3.0, -9.0})}) {
        const Tightness found = measure<S>(mesh, precision, Layer::farthest);
        // A scheme that is sparse somewhere, as the conchoid at its south pole, has a wide bound everywhere.
        const double reach = S::with_precision(precision).stencil_radius();
        EXPECT_TRUE(found.bounded || reach > 10.0 * kDegree) << S::name << " at " << precision;
        if (!found.bounded) continue;
        EXPECT_GT(found.worst_share, 0.02) << S::name << " at " << precision << ": the bound says nothing";
      }
      measure<S>(pair.socket, precision, Layer::nearest);
    }
  });
}

TEST(ErrorBound, FallsWithThePrecision) {
  const TriangleMesh ball = make_ball_socket_pair(1000).ball;
  for_each_scheme([&]<class S>() {
    double last = HUGE_VAL;
    for (const double precision : {2.0, 1.0, 0.5, 0.25}) {
      const S scheme = S::with_precision(precision);
      const auto table = fill_exact(ball, scheme, Layer::farthest);
      const auto slopes = largest_slopes(ball, scheme);
      double largest = 0.0;
      for (const Vec3& u : test::random_directions(2000, 41)) {
        largest = std::max(largest, error_bound_at(table, slopes, u));
      }
      EXPECT_LT(largest, 0.6 * last) << S::name << " at " << precision;
      last = largest;
    }
  });
}

TEST(ErrorBound, IsInfiniteNearAnEdgeOnFace) {
  TriangleMesh mesh = sphere(22.0, 500);
  const auto first = static_cast<VertexIndex>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {{25, 0, 0}, {30, 0, 0}, {27, 1, 0}});
  mesh.faces.push_back({first, first + 1, first + 2});
  const Rsid scheme = Rsid::with_precision(2.0);
  const auto slopes = largest_slopes(mesh, scheme);
  const auto table = fill_exact(mesh, scheme, Layer::farthest);
  EXPECT_LT(error_bound_at(table, slopes, {-1.0, 0.1, 0.2}), 1.0);
  const auto near_face = scheme.stencil({27.0, 0.3, 0.0});
  EXPECT_TRUE(std::isinf(slopes[near_face.entry[0]]));
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of DirectionBounds for every scheme, coarse and without halving. Compiled in one batch with
// table_bound_test.cpp it costs 2 s more, and 40 s without it:
//   |table.radius_at(u) - radius of the mesh along u| <= at(u) <= everywhere(), at(u) <= error_bound_at(u)
#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "support/directions.hpp"
#include "support/every_scheme.hpp"
#include "support/turned.hpp"
#include "table/direction_bounds.hpp"
#include "table/exact_raster.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

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

TEST(SchemeBounds, OfDirectionsHoldAndSayMuch) {
  const TriangleMesh mesh = slanted_cone();
  test::every_scheme([&]<class S>() {
    SCOPED_TRACE(S::name);
    const double share = largest_share_of_bounds(mesh, S::with_precision(9.0));
    EXPECT_GT(share, HasPatches<S> ? 0.3 : 0.02);
  });
}

}  // namespace
}  // namespace impinge

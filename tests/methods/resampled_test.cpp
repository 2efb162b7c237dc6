// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis' way to fill a helix in short time, by way of an RSID table of its raster:
//   fill_resampled()[i] = bilinear interpolation of fill_thesis() at the angles of entry i, by hand
//   |fill_resampled()[i] - exact radius| <= E + error_bound_at(exact RSID table) <= resampling_bound()
// and no surface where the rim crosses what an entry would read.
#include "methods/resampled.hpp"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "support/directions.hpp"
#include "support/every_scheme.hpp"
#include "support/turned.hpp"
#include "table/error_bound.hpp"
#include "table/exact_raster.hpp"
#include "table/pairwise.hpp"

namespace impinge::lab {
namespace {

const Eigen::Matrix3d kTilt = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();

TEST(Resampled, TheRasterHasThePrecisionOfTable6) {
  for (const auto& [turns, columns] : {std::pair{229U, 360U}, {458U, 720U}, {2292U, 3600U}, {4584U, 7200U}}) {
    EXPECT_EQ(raster_for(Usid::with_turns(turns).precision_deg()).columns(), columns) << turns << " turns";
  }
  EXPECT_EQ(raster_for(500.0).columns(), 4U);
}

// Entry i of the helix of k turns: cos(phi) = 1 - 2 i / (k^2 - 1), theta = 2 k phi (Eq. 9), written anew.
TEST(Resampled, ReadsTheThesisRasterBilinearly) {
  const TriangleMesh ball = test::turned(make_ball_socket_pair(1000).ball, kTilt);
  const Usid helix = Usid::with_precision(2.0);
  const auto raster = fill_thesis(ball, Rsid::with_precision(2.0), Layer::farthest);
  const auto table = fill_resampled(ball, helix, Layer::farthest);
  const auto at = [&](std::size_t row, std::size_t column) {
    return raster.radii()[row * 180 + column % 180];
  };
  const auto last = static_cast<double>(helix.size() - 1);
  for (std::size_t i = 0; i < helix.size(); ++i) {
    const double phi = std::acos(1.0 - 2.0 * static_cast<double>(i) / last);
    const double theta = 2.0 * static_cast<double>(helix.helix_turns()) * phi;
    const double row = phi / (2.0 * kDegree);
    const double column = (theta - 2.0 * kPi * std::floor(theta / (2.0 * kPi))) / (2.0 * kDegree);
    const auto m = std::min(static_cast<std::size_t>(row), std::size_t{89});
    const auto n = static_cast<std::size_t>(column);
    const double a = row - static_cast<double>(m);
    const double b = column - static_cast<double>(n);
    const double expected = (1.0 - a) * ((1.0 - b) * at(m, n) + b * at(m, n + 1)) +
                            a * ((1.0 - b) * at(m + 1, n) + b * at(m + 1, n + 1));
    ASSERT_NEAR(table.radii()[i], expected, 1e-9) << "entry " << i;
  }
}

// Each entry keeps the bound of its direction, and that is below the bound of the mesh.
template <class S>
double worst_share(const TriangleMesh& mesh, double precision) {
  const S scheme = S::with_precision(precision);
  const auto table = fill_resampled(mesh, scheme, Layer::farthest);
  const auto exact = fill_exact(mesh, raster_for(scheme.precision_deg()), Layer::farthest);
  const auto slopes = largest_slopes(mesh, exact.scheme());
  const double drawn = thesis_raster_bound(mesh);
  const double everywhere = resampling_bound(mesh, scheme.precision_deg());
  const RayCaster oracle(mesh);
  double worst = 0.0;
  for (std::size_t i = 0; i < scheme.size(); i += scheme.size() / 1500 + 1) {
    const Vec3 u = scheme.direction(i);
    const double bound = drawn + error_bound_at(exact, slopes, u);
    const double error = std::abs(table.radii()[i] - oracle.cast(u, Layer::farthest));
    EXPECT_LE(error, bound + 1e-11) << S::name << " entry " << i;
    if (std::isfinite(bound)) {
      EXPECT_LE(bound, everywhere * (1.0 + 1e-6)) << S::name << " entry " << i;
    }
    worst = std::max(worst, error / everywhere);
  }
  return worst;
}

TEST(Resampled, KeepsItsBound) {
  const TriangleMesh ball = make_ball_socket_pair(300).ball;
  const TriangleMesh aside = sphere(22.0, 1000, {5.0, -4.0, 3.0});
  test::every_scheme([&]<class S>() {
    for (const TriangleMesh& mesh : {ball, test::turned(octahedron(20.0), kTilt)}) worst_share<S>(mesh, 5.0);
  });
  for (const double precision : {2.0, 1.0}) {
    for (const TriangleMesh& mesh : {ball, aside}) {
      EXPECT_GT(worst_share<Usid>(mesh, precision), 0.025) << precision << ": the bound says nothing";
    }
  }
}

TEST(Resampled, TheBoundIsInfiniteForAnEdgeOnFace) {
  TriangleMesh mesh = octahedron(20.0);
  mesh.vertices.push_back(Vec3::Zero());
  mesh.faces.push_back({0, 2, 6});
  EXPECT_EQ(resampling_bound(mesh, 1.0), std::numeric_limits<double>::infinity());
}

// An entry has a surface exactly where the cell of the raster that it lies in has one: not in a rim cell.
TEST(Resampled, AnEntryInARimCellOfTheRasterHasNoSurface) {
  const TriangleMesh socket = test::turned(make_ball_socket_pair(300).socket, kTilt);
  const auto raster = fill_thesis(socket, Rsid::with_precision(3.0), Layer::nearest);
  test::every_scheme([&]<class S>() {
    const S scheme = S::with_precision(3.0);
    const auto table = fill_resampled(socket, scheme, Layer::nearest);
    std::size_t in_rim_cells = 0;
    for (std::size_t i = 0; i < scheme.size(); ++i) {
      if (!raster.is_rim_cell(raster.scheme().stencil(scheme.direction(i)).cell)) continue;
      ++in_rim_cells;
      ASSERT_TRUE(std::isnan(table.radii()[i])) << S::name << " entry " << i;
    }
    EXPECT_GT(in_rim_cells, 50U) << S::name;
  });
}

// Outside of the rim nothing is met, by any of the cells that read entries inside of it; and the surface is
// there again a stencil of the raster and two of the scheme inside.
TEST(Resampled, EndsAtTheRimAndNotMuchBefore) {
  const TriangleMesh socket = make_ball_socket_pair(1000).socket;  // its rim is at 87 degrees
  const RayCaster oracle(socket);
  test::every_scheme([&]<class S>() {
    const S scheme = S::with_precision(3.0);
    const auto table = fill_resampled(socket, scheme, Layer::nearest);
    const double taken = raster_for(scheme.precision_deg()).stencil_radius() + 2.5 * scheme.stencil_radius();
    for (double theta = 0.0; theta < 2.0 * kPi; theta += 0.02) {
      for (const double outside : {1e-4, 1e-3, 0.01}) {
        const Vec3 u = to_direction({87.0 * kDegree + outside, theta});
        ASSERT_TRUE(std::isnan(oracle.cast(u, Layer::nearest)));
        EXPECT_TRUE(std::isnan(table.radius_at(u))) << S::name << ' ' << theta;
      }
      const Vec3 u = to_direction({87.0 * kDegree - taken, theta});
      EXPECT_NEAR(table.radius_at(u), 26.0, 0.2) << S::name << ' ' << theta;
    }
  });
}

TEST(Resampled, AHoleBetweenEntriesIsMasked) {
  const TriangleMesh whole = sphere(22.0, 5000);
  const Face& face = whole.faces[1700];
  const Vec3 into_hole =
      (corner(whole, face, 0) + corner(whole, face, 1) + corner(whole, face, 2)).normalized();
  TriangleMesh holed = whole;
  holed.faces.erase(holed.faces.begin() + 1700);
  const Usid helix = Usid::with_precision(5.0);
  EXPECT_TRUE(std::isnan(fill_resampled(holed, helix, Layer::nearest).radius_at(into_hole)));
  EXPECT_NEAR(fill_resampled(whole, helix, Layer::nearest).radius_at(into_hole), 22.0, 0.05);
}

}  // namespace
}  // namespace impinge::lab

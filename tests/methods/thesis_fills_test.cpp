// SPDX-License-Identifier: GPL-3.0-or-later
// The plain test of each pair against the oracle of exact signs:
//   thesis_ray_radius() = RayCaster::cast() but for rounding, away from faces seen edge-on
#include "methods/thesis_fills.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "gap/gap_scan.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/fill_method.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/uniform_directions.hpp"
#include "support/directions.hpp"
#include "support/every_scheme.hpp"
#include "support/random_cases.hpp"
#include "support/turned.hpp"
#include "table/error_bound.hpp"
#include "table/exact_raster.hpp"
#include "table/pairwise.hpp"

namespace impinge::lab {
namespace {

constexpr double kRayRounding = 1e-9;  // mm

void expect_the_oracle(const TriangleMesh& mesh, const RayCaster& oracle, const Vec3& u, Layer layer) {
  const double expected = oracle.cast(u, layer);
  const double found = thesis_ray_radius(mesh, u, layer);
  ASSERT_EQ(std::isnan(found), std::isnan(expected)) << u.transpose();
  if (!std::isnan(expected)) {
    ASSERT_NEAR(found, expected, kRayRounding) << u.transpose();
  }
}

// At all entries of a grid, of which some lie on edges and vertices.
TEST(ThesisPairwise, FillsTheTableOfTheOracle) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  const Rsid scheme = Rsid::with_precision(5.0);
  for (const auto& [mesh, layer] : {std::pair{&pair.ball, Layer::farthest}, {&pair.socket, Layer::nearest}}) {
    const auto expected = fill_pairwise(*mesh, scheme, layer);
    const auto found = fill_thesis_pairwise(*mesh, scheme, layer);
    for (std::size_t i = 0; i < scheme.size(); ++i) {
      ASSERT_EQ(std::isnan(found.radii()[i]), std::isnan(expected.radii()[i])) << i;
      if (!std::isnan(expected.radii()[i])) {
        ASSERT_NEAR(found.radii()[i], expected.radii()[i], kRayRounding) << i;
      }
    }
    for (std::size_t c = 0; c < scheme.cells(); ++c)
      EXPECT_EQ(found.is_rim_cell(c), expected.is_rim_cell(c)) << c;
  }
}

TEST(ThesisPairwise, SeesVerticesAndTheMiddlesOfEdges) {
  const TriangleMesh mesh = octahedron(20.0);
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& a = mesh.vertices[face[k]];
      const Vec3& b = mesh.vertices[face[(k + 1) % 3]];
      EXPECT_NEAR(thesis_ray_radius(mesh, a.normalized(), Layer::farthest), 20.0, kRayRounding);
      EXPECT_NEAR(thesis_ray_radius(mesh, (a + b).normalized(), Layer::farthest), 20.0 / std::sqrt(2.0),
                  kRayRounding);
    }
  }
}

// Bodies about the centre and off it, both layers, rays in all directions.
TEST(ThesisPairwiseAttack, IsTheOracleAlongRandomRays) {
  std::mt19937_64 random(18);
  std::uniform_real_distribution<double> place(-8.0, 8.0);
  constexpr std::size_t kRays = 50;  // of a body
  for (std::size_t done = 0; done < random_cases(); done += kRays) {
    const TriangleMesh mesh = sphere(22.0, 80, {place(random), place(random), place(random)});
    const RayCaster oracle(mesh);
    const Layer layer = done / kRays % 2 == 0 ? Layer::farthest : Layer::nearest;
    for (const Vec3& u : uniform_directions(kRays, random())) expect_the_oracle(mesh, oracle, u, layer);
  }
}

// Concentric spheres of radii B and S. A ball vertex has d_i = B and reads d = S, a socket vertex has d_i = S
// and reads d = B: the comparison d <= d_i says S <= B of the first and B <= S of the second.

struct Both {
  ScanVerdicts ball;
  ScanVerdicts socket;
};

Both compare(double ball_radius, double socket_radius) {
  const Rsid scheme = Rsid::with_precision(2.0);
  const TriangleMesh ball = sphere(ball_radius, 500);
  const TriangleMesh socket = sphere(socket_radius, 500);
  std::vector<double> gap(ball.vertices.size());
  scan_gaps(fill_exact(socket, scheme, Layer::nearest), ball.vertices, {}, Surface::ball, gap);
  const ScanVerdicts of_ball = compare_as_written(gap, Surface::ball);
  gap.resize(socket.vertices.size());
  scan_gaps(fill_exact(ball, scheme, Layer::farthest), socket.vertices, {}, Surface::socket, gap);
  return {of_ball, compare_as_written(gap, Surface::socket)};
}

TEST(Algorithm2, CallsEverySocketVertexOfAClearPoseImpinged) {
  const Both clear = compare(22.0, 26.0);
  EXPECT_GT(clear.ball.met, 0U);
  EXPECT_EQ(clear.ball.by_gap, 0U);
  EXPECT_EQ(clear.ball.as_written, 0U);
  EXPECT_GT(clear.socket.met, 0U);
  EXPECT_EQ(clear.socket.by_gap, 0U);
  EXPECT_EQ(clear.socket.as_written, clear.socket.met);
}

TEST(Algorithm2, CallsNoSocketVertexOfAPenetratingPoseImpinged) {
  const Both penetrating = compare(27.0, 26.0);
  EXPECT_EQ(penetrating.ball.by_gap, penetrating.ball.met);
  EXPECT_EQ(penetrating.ball.as_written, penetrating.ball.met);
  EXPECT_EQ(penetrating.socket.by_gap, penetrating.socket.met);
  EXPECT_EQ(penetrating.socket.as_written, 0U);
}

TEST(Algorithm2, CountsContactInBothAndNoSurfaceInNone) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> gap{0.0, none, 1.0, -1.0, none};
  for (const Surface scanned : {Surface::ball, Surface::socket}) {
    const ScanVerdicts verdicts = compare_as_written(gap, scanned);
    EXPECT_EQ(verdicts.met, 3U);
    EXPECT_EQ(verdicts.by_gap, 2U);
    EXPECT_EQ(verdicts.as_written, 2U);
  }
}

// The thesis' way to fill a helix in short time, by way of an RSID table of its raster:
//   fill_resampled()[i] = bilinear interpolation of fill_thesis() at the angles of entry i, by hand
//   |fill_resampled()[i] - exact radius| <= E + error_bound_at(exact RSID table) <= resampling_bound()
// and no surface where the rim crosses what an entry would read.

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

// A way of filling is checked before it is timed: what is right passes, what is wrong by more than its
// tolerance does not.

constexpr std::size_t kAll = 1'000'000;

TEST(FillMethod, AllPassTheirCheck) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  for (const auto& method : {kPairwiseThesis, kRsidThesis, kRsid}) {
    EXPECT_NO_THROW(require_filling(method, pair, Rsid::with_precision(4.0), kAll)) << method.name;
  }
  for (const auto& method : {kUsidThesis, kUsid}) {
    EXPECT_NO_THROW(require_filling(method, pair, Usid::with_precision(4.0), kAll)) << method.name;
  }
}

// The raster of the thesis is no exact one, and a table that lies is found out, however wide its tolerance.
TEST(FillMethod, AWrongOneDoesNotPass) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  FillMethod<Usid> claims_exact = kUsidThesis;
  claims_exact.tolerance = exact_tolerance;
  EXPECT_THROW(require_filling(claims_exact, pair, Usid::with_precision(4.0), kAll), std::runtime_error);
  FillMethod<Usid> wrong = kUsidThesis;
  wrong.fill = [](const TriangleMesh& mesh, const Usid& scheme, Layer layer) {
    auto table = fill_resampled(mesh, scheme, layer);
    table.radii()[table.radii().size() / 4] += 2.0 * resampling_bound(mesh, scheme.precision_deg());
    return table;
  };
  EXPECT_THROW(require_filling(wrong, pair, Usid::with_precision(4.0), kAll), std::runtime_error);
}

// The tables are those of the ball's outer skin and of the socket's inner one.
TEST(FillMethod, FillsBothSurfaces) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  int filled = 0;
  for_both_tables(kUsid, pair, Usid::with_precision(5.0),
                  [&](const auto& table, const TriangleMesh& mesh, Layer layer) {
                    const bool ball = layer == Layer::farthest;
                    EXPECT_EQ(&mesh, ball ? &pair.ball : &pair.socket);
                    EXPECT_NEAR(table.radii()[0], ball ? 22.0 : 26.0, 1.0);
                    ++filled;
                  });
  EXPECT_EQ(filled, 2);
}

// Tables that are kept and filled again hold what tables made for the purpose hold, bit for bit.

constexpr double kPrecision = 2.0;  // degrees

void expect_same_bits(std::span<const double> found, std::span<const double> expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    ASSERT_TRUE(found[i] == expected[i] || (std::isnan(found[i]) && std::isnan(expected[i]))) << i;
}

TEST(KeptTables, HoldWhatNewTablesHoldHoweverOftenTheyAreFilled) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  const auto ball = fill_thesis(pair.ball, Rsid::with_precision(kPrecision), Layer::farthest);
  const auto socket = fill_thesis(pair.socket, Rsid::with_precision(kPrecision), Layer::nearest);
  KeptTables kept(pair, kPrecision);
  for (int times = 0; times < 3; ++times) {
    kept.fill_grids();
    expect_same_bits(kept.ball_grid().radii(), ball.radii());
    expect_same_bits(kept.socket_grid().radii(), socket.radii());
  }
}

TEST(KeptTables, HelicesAreReadFromTheGrids) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  KeptTables kept(pair, kPrecision);
  EXPECT_TRUE(std::isnan(kept.ball_helix().radii()[0]));
  kept.fill_helices();
  const auto ball = resample(kept.ball_grid(), kept.ball_helix().scheme());
  const auto socket = resample(kept.socket_grid(), kept.socket_helix().scheme());
  expect_same_bits(kept.ball_helix().radii(), ball.radii());
  expect_same_bits(kept.socket_helix().radii(), socket.radii());
  EXPECT_NEAR(kept.ball_helix().radii()[0], 22.0, 1.0);
}

// Another joint's tables are found out.
TEST(KeptTables, AreCheckedBeforeTheyAreTimed) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  KeptTables kept(pair, kPrecision);
  EXPECT_NO_THROW(require_kept(kept, pair, 100'000));
  BallSocketPair larger = pair;
  for (Vec3& v : larger.ball.vertices) v *= 1.5;
  EXPECT_THROW(require_kept(kept, larger, 100'000), std::runtime_error);
}

}  // namespace
}  // namespace impinge::lab

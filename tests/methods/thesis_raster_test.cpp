// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis' rasteriser: distance linear in (theta, phi) over flat triangles of the chart.
//   fill_thesis() = brute force over the same chart triangles, at every entry
//   |fill_thesis() - exact radius| <= thesis_raster_bound()
#include "methods/thesis_raster.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/chart.hpp"
#include "support/joined.hpp"
#include "support/random_cases.hpp"
#include "support/turned.hpp"
#include "table/pairwise.hpp"

namespace impinge::lab {
namespace {

// Radius at a chart point by barycentric coordinates over all triangles and whole turns of theta; NaN if none
// holds it.
double brute_force(const std::vector<ChartTriangle>& triangles, double theta, double phi) {
  for (const auto& [a, b, c] : triangles) {
    const double area = (b.theta - a.theta) * (c.phi - a.phi) - (c.theta - a.theta) * (b.phi - a.phi);
    if (area == 0.0) continue;
    for (const double turn : {-2.0 * kPi, 0.0, 2.0 * kPi}) {
      const double x = theta + turn - a.theta;
      const double y = phi - a.phi;
      const double wb = (x * (c.phi - a.phi) - (c.theta - a.theta) * y) / area;
      const double wc = ((b.theta - a.theta) * y - x * (b.phi - a.phi)) / area;
      const double slack = 1e-11;
      if (wb < -slack || wc < -slack || wb + wc > 1.0 + slack) continue;
      return a.radius + wb * (b.radius - a.radius) + wc * (c.radius - a.radius);
    }
  }
  return kNoSurface;
}

void expect_linear_on_the_chart(const TriangleMesh& mesh, double precision) {
  const Rsid scheme = Rsid::with_precision(precision);
  const auto table = fill_thesis(mesh, scheme, Layer::farthest);
  std::vector<ChartTriangle> triangles;
  for (const Face& face : mesh.faces) {
    for (const ChartTriangle& t : chart_triangles(cone_of(mesh, face))) triangles.push_back(t);
  }
  for (std::size_t i = 0; i < scheme.rows(); ++i) {
    for (std::size_t j = 0; j < scheme.columns(); ++j) {
      const double expected = brute_force(triangles, static_cast<double>(j) * scheme.spacing(),
                                          static_cast<double>(i) * scheme.spacing());
      const double found = table.radii()[i * scheme.columns() + j];
      ASSERT_EQ(std::isnan(found), std::isnan(expected)) << "row " << i << " column " << j;
      if (!std::isnan(expected)) {
        ASSERT_NEAR(found, expected, 1e-8) << "row " << i << " column " << j;
      }
    }
  }
}

TriangleMesh octahedron_turned_about_x(double angle) {
  TriangleMesh mesh = octahedron(20.0);
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, Vec3::UnitX()).toRotationMatrix();
  for (Vec3& v : mesh.vertices) {
    v = rotation * v;
    for (double& x : v) x = std::abs(x) < 1e-12 ? 0.0 : x;
  }
  return mesh;
}

TEST(ThesisRaster, IsLinearOnTheChart) {
  expect_linear_on_the_chart(octahedron(20.0), 5.0);                      // case 1: the pole is a vertex
  expect_linear_on_the_chart(octahedron_turned_about_x(kPi / 4.0), 5.0);  // case 2: on an edge
  expect_linear_on_the_chart(octahedron_turned_about_x(0.6), 5.0);
  // Case 3: inside a face.
  expect_linear_on_the_chart(test::turned(octahedron_turned_about_x(0.6), 0.5, Vec3::UnitY()), 5.0);
  expect_linear_on_the_chart(sphere(22.0, 300, {4.0, -3.0, 6.0}), 3.0);
}

// Number of chart triangles of the three pole cases: two edges away from the pole make two triangles each in
// case 2, one edge in case 1, three in case 3.
TEST(ThesisRaster, PoleCasesCutTheFaceAsInFigure34) {
  const auto count = [](const Vec3& a, const Vec3& b, const Vec3& c) {
    return chart_triangles({a, b, c}).size();
  };
  EXPECT_EQ(count({1, 0, 1}, {1, 1, 1}, {2, 1, 1}), 1U);
  EXPECT_EQ(count({0, 0, 1}, {1, 0, 1}, {0, 1, 1}), 2U);
  EXPECT_EQ(count({-1, 0, 1}, {1, 0, 1}, {0, 1, 1}), 4U);
  EXPECT_EQ(count({-1, -1, 1}, {1, -1, 1}, {0, 1, 1}), 6U);
  EXPECT_EQ(count({-1, -1, -1}, {1, -1, -1}, {0, 1, -1}), 6U);
}

// The chart covers the sphere exactly once: areas of the triangles of a closed body sum to 2 pi * pi.
TEST(ThesisRaster, ChartOfAClosedBodyCoversTheGridOnce) {
  for (const TriangleMesh& mesh :
       {octahedron(20.0), octahedron_turned_about_x(kPi / 4.0), sphere(22.0, 300, {1.0, 2.0, 3.0})}) {
    double area = 0.0;
    for (const Face& face : mesh.faces) {
      for (const auto& [a, b, c] : chart_triangles(cone_of(mesh, face))) {
        area += std::abs((b.theta - a.theta) * (c.phi - a.phi) - (c.theta - a.theta) * (b.phi - a.phi)) / 2.0;
      }
    }
    EXPECT_NEAR(area, 2.0 * kPi * kPi, 1e-9);
  }
}

// Edges that pass the pole within rounding, on one side of it or the other.
TEST(ThesisRaster, EdgesBesideThePoleAreUnrolledTheRightWay) {
  const Rsid scheme = Rsid::with_precision(5.0);
  for (int k = 1; k <= 100; ++k) {
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(0.0617 * k, Vec3::UnitZ()) * Eigen::AngleAxisd(kPi / 4.0, Vec3::UnitX()))
            .toRotationMatrix();
    const auto table = fill_thesis(test::turned(octahedron(20.0), turn), scheme, Layer::farthest);
    for (const double radius : table.radii()) ASSERT_FALSE(std::isnan(radius)) << k;
  }
}

// The raster one column after the other, without a thought for speed: the radius of each entry from the ends
// of its row's span.
RadialTable<Rsid> drawn_one_by_one(const TriangleMesh& mesh, const Rsid& scheme, Layer layer) {
  constexpr double kSlack = 1e-9;  // of a step
  RadialTable<Rsid> table(scheme);
  const double step = scheme.spacing();
  const auto columns = static_cast<long>(scheme.columns());
  for (const Face& face : mesh.faces) {
    for (const ChartTriangle& t : chart_triangles(cone_of(mesh, face))) {
      for (std::size_t i = 0; i < scheme.rows(); ++i) {
        const double phi = static_cast<double>(i) * step;
        std::vector<std::pair<double, double>> ends;  // column and radius
        for (std::size_t k = 0; k < 3; ++k) {
          const ChartPoint& a = t[k];
          const ChartPoint& b = t[(k + 1) % 3];
          if (std::abs(a.phi - phi) <= kSlack * step) ends.emplace_back(a.theta / step, a.radius);
          if (std::min(a.phi, b.phi) >= phi - kSlack * step || std::max(a.phi, b.phi) <= phi + kSlack * step)
            continue;
          const double share = (phi - a.phi) / (b.phi - a.phi);
          ends.emplace_back((a.theta + share * (b.theta - a.theta)) / step,
                            a.radius + share * (b.radius - a.radius));
        }
        if (ends.empty()) continue;
        const auto by_column = [](const auto& x, const auto& y) { return x.first < y.first; };
        const auto left = *std::ranges::min_element(ends, by_column);
        const auto right = *std::ranges::max_element(ends, by_column);
        for (auto j = static_cast<long>(std::ceil(left.first - kSlack));
             j <= static_cast<long>(std::floor(right.first + kSlack)); ++j) {
          double radius = left.second;
          if (right.first > left.first) {
            const double share = (static_cast<double>(j) - left.first) / (right.first - left.first);
            radius = left.second + std::clamp(share, 0.0, 1.0) * (right.second - left.second);
          }
          const auto column = static_cast<std::size_t>(((j % columns) + columns) % columns);
          keep(table.radii()[i * scheme.columns() + column], radius, layer);
        }
      }
    }
  }
  return table;
}

void expect_the_bits_drawn_one_by_one(const TriangleMesh& mesh, double precision, Layer layer) {
  const Rsid scheme = Rsid::with_precision(precision);
  const auto expected = drawn_one_by_one(mesh, scheme, layer);
  const auto found = fill_thesis(mesh, scheme, layer);
  for (std::size_t i = 0; i < scheme.size(); ++i) {
    const double radius = expected.radii()[i];
    ASSERT_TRUE(found.radii()[i] == radius || (std::isnan(found.radii()[i]) && std::isnan(radius)))
        << i << ": " << found.radii()[i] << " instead of " << radius;
  }
}

// Several columns at a time are the same bits as one after the other, at seams, poles and rims, where rows
// are shorter than a vector and where faces lie behind one another.
TEST(ThesisRaster, HasTheBitsOfOneColumnAfterTheOther) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  for (const double precision : {30.0, 6.0, 0.9}) {
    expect_the_bits_drawn_one_by_one(octahedron_turned_about_x(0.6), precision, Layer::farthest);
    expect_the_bits_drawn_one_by_one(octahedron(20.0), precision, Layer::nearest);
    for (const Layer layer : {Layer::farthest, Layer::nearest}) {
      expect_the_bits_drawn_one_by_one(pair.ball, precision, layer);
      expect_the_bits_drawn_one_by_one(pair.socket, precision, layer);
    }
  }
  // One inside of the other: each entry is drawn twice.
  const TriangleMesh shells = test::joined(sphere(22.0, 100), sphere(15.0, 80, {2.0, -3.0, 1.0}));
  for (const Layer layer : {Layer::farthest, Layer::nearest})
    expect_the_bits_drawn_one_by_one(shells, 1.0, layer);
}

TEST(ThesisRaster, LeavesNoHoleAndKeepsItsBound) {
  constexpr std::size_t kStep = 37;  // of the entries whose errors are looked at, in every column of the grid
  for (const std::size_t faces : {300U, 1000U, 3000U}) {
    for (const TriangleMesh& mesh :
         {sphere(22.0, faces), sphere(22.0, faces, {5.0, -4.0, 3.0}), make_ball_socket_pair(faces).ball}) {
      const Rsid scheme = Rsid::with_precision(1.0);
      const auto table = fill_thesis(mesh, scheme, Layer::farthest);
      for (const double radius : table.radii()) ASSERT_FALSE(std::isnan(radius));
      const RayCaster oracle(mesh);
      const double bound = thesis_raster_bound(mesh);
      double worst = 0.0;
      for (std::size_t i = 0; i < scheme.size(); i += kStep) {
        const double exact = oracle.cast(scheme.direction(i), Layer::farthest);
        worst = std::max(worst, std::abs(table.radii()[i] - exact));
      }
      EXPECT_LE(worst, bound);
      EXPECT_GE(worst, bound / 40.0) << "the bound says nothing";
    }
  }
}

// Two faces of 1e-3 to 1e-8 rad that meet near an entry: what the raster takes for being on an edge is more
// than linear interpolation costs them.
TEST(ThesisRaster, TinyFacesKeepTheirBound) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (const double precision : {1.0, 30.0, 90.0}) {
    RadialTable<Rsid> table(Rsid::with_precision(precision));
    const Rsid& scheme = table.scheme();
    for (std::size_t k = 0; k < random_cases(); ++k) {
      const auto i = static_cast<std::size_t>(share(random) * static_cast<double>(scheme.size()));
      const Vec3 u = scheme.direction(i);
      const double width = std::pow(10.0, -3.0 - 5.0 * share(random));
      const double aside = (share(random) - 0.5) * (k % 2 == 0 ? 4e-9 * scheme.spacing() : width);
      const Eigen::AngleAxisd turn(2.0 * kPi * share(random), u);
      const Vec3 along = turn * u.unitOrthogonal();
      const double slope[] = {3.0 * share(random), -3.0 * share(random)};
      const auto at = [&](double a, double b) -> Vec3 {  // of the edge, and off it
        const double radius = 20.0 * std::exp(slope[b > 0.0 ? 1 : 0] * b * width);
        return radius * (u + width * a * along + (width * b + aside) * u.cross(along)).normalized();
      };
      const TriangleMesh mesh{{at(-1.0, 0.0), at(1.5, 0.0), at(0.3, 1.0), at(-0.2, -2.0)},
                              {{0, 1, 2}, {1, 0, 3}}};
      std::ranges::fill(table.radii(), kNoSurface);
      const Layer layer = k % 3 == 0 ? Layer::nearest : Layer::farthest;
      draw_thesis(mesh, layer, table);
      double exact = kNoSurface;  // RayCaster loses digits of so small a face
      for (const Face& face : mesh.faces) {
        const TriangleCone cone = cone_of(mesh, face);
        if (cone.contains(u)) keep(exact, cone.radius(u), layer);
      }
      if (std::isnan(exact) || std::isnan(table.radii()[i])) continue;
      EXPECT_LE(std::abs(table.radii()[i] - exact), thesis_raster_bound(mesh)) << k << ", width " << width;
    }
  }
}

// On a sphere all corners have one radius, so the drawn surface is the sphere itself and the exact one its
// chords: the error is the sagitta R (1 - cos rho) of the largest face, and none of it is lost.
TEST(ThesisRaster, DrawsTheSmoothSphereBehindTheFaces) {
  const TriangleMesh mesh = sphere(22.0, 1000);
  const Rsid scheme = Rsid::with_precision(1.0);
  const auto table = fill_thesis(mesh, scheme, Layer::farthest);
  for (const double radius : table.radii()) EXPECT_NEAR(radius, 22.0, 0.02);
}

TEST(ThesisRaster, BoundFallsWithTheSquareOfTheFaceSize) {
  const double coarse = thesis_raster_bound(sphere(22.0, 1000));
  const double fine = thesis_raster_bound(sphere(22.0, 16000));
  EXPECT_GT(coarse / fine, 8.0);  // 16 times the faces, a quarter of the size
  EXPECT_LT(coarse / fine, 32.0);
}

TEST(ThesisRaster, SocketIsDrawnInsideItsRim) {
  const Rsid scheme = Rsid::with_precision(1.0);
  const auto table = fill_thesis(cup(26.0, 60.0, 3000), scheme, Layer::nearest);
  EXPECT_FALSE(std::isnan(table.radius_at(to_direction({58.0 * kDegree, 1.0}))));
  EXPECT_TRUE(std::isnan(table.radius_at(to_direction({62.0 * kDegree, 1.0}))));
}

// Contract (thesis, Section 3.2, Figures 33 and 34): drawn with care for poles and seam, a face fills the
// entries that it meets, up to those between a straight edge on the chart and the great circle; drawn between
// its corners as mapped directly, it does so only away from poles and seam.

constexpr double kSide = 6.0 * kDegree;  // half a side of a face, seen from the centre

// A face about a direction, one corner of it ahead in the direction of growing phi.
TriangleMesh face_about(Angles middle, double radius = 25.0) {
  const Vec3 u = to_direction(middle);
  const Vec3 down = to_direction({middle.phi + kPi / 2.0, middle.theta});
  const Vec3 across = u.cross(down);
  const auto at = [&](double turn) {
    return Vec3(radius * (u + kSide * (std::cos(turn) * down + std::sin(turn) * across)));
  };
  return {{at(0.1), at(0.1 + 2.0 * kPi / 3.0), at(0.1 + 4.0 * kPi / 3.0)}, {{0, 1, 2}}};
}

template <class Predicate>
long count(const std::vector<EntryCoverage>& entries, Predicate&& predicate) {
  return std::ranges::count_if(entries, predicate);
}

bool drawn_amiss(const EntryCoverage& e) { return e.drawn != e.met; }
bool direct_amiss(const EntryCoverage& e) { return e.direct != e.met; }

TEST(ChartCoverage, AwayFromPolesAllWaysAgree) {
  const auto entries = chart_coverage(face_about({1.5, 2.0}), Rsid::with_precision(0.5));
  const long met = count(entries, &EntryCoverage::met);
  EXPECT_GT(met, 100);
  EXPECT_EQ(count(entries, [](const auto& e) { return e.direct != e.drawn; }), 0);
  EXPECT_LT(count(entries, drawn_amiss), met / 20);
  for (const EntryCoverage& e : entries) {
    if (e.met && e.drawn) {
      EXPECT_NEAR(e.drawn_radius, e.met_radius, 0.05 * e.met_radius);
    }
    EXPECT_EQ(std::isnan(e.met_radius), !e.met);
    EXPECT_EQ(std::isnan(e.drawn_radius), !e.drawn);
  }
}

TEST(ChartCoverage, DirectMapMissesThePole) {
  const Rsid scheme = Rsid::with_precision(1.0);
  const auto entries = chart_coverage(face_about({0.03, 1.0}), scheme);
  for (std::size_t i = 0; i < scheme.columns(); ++i) {
    EXPECT_EQ(entries[i].entry, i);  // the whole row of the pole
    EXPECT_TRUE(entries[i].met && entries[i].drawn && !entries[i].direct);
  }
  const long met = count(entries, &EntryCoverage::met);
  EXPECT_GT(count(entries, direct_amiss), met / 2);
  // A great circle bends towards the pole: the straight edge on the chart takes in more, never less.
  EXPECT_EQ(count(entries, [](const auto& e) { return e.met && !e.drawn; }), 0);
}

// A face and the same face turned by whole columns fill as many entries, across the seam or not; the direct
// map does not.
TEST(ChartCoverage, SeamChangesNothingButTheDirectMap) {
  const Rsid scheme = Rsid::with_precision(1.0);
  const auto clear = chart_coverage(face_about({1.1, 90.0 * kDegree + 0.001}), scheme);
  const auto across = chart_coverage(face_about({1.1, 0.001}), scheme);
  EXPECT_EQ(count(across, &EntryCoverage::met), count(clear, &EntryCoverage::met));
  EXPECT_EQ(count(across, &EntryCoverage::drawn), count(clear, &EntryCoverage::drawn));
  EXPECT_GT(count(across, direct_amiss), 10 * count(clear, direct_amiss));
}

TEST(ChartCoverage, FacesAlongADirection) {
  const TriangleMesh body = octahedron(20.0);
  EXPECT_EQ(faces_along(body, Vec3(1.0, 1.0, 1.0).normalized()).faces.size(), 1U);
  EXPECT_EQ(faces_along(body, Vec3(1.0, 1.0, 0.0).normalized()).faces.size(), 2U);
  EXPECT_EQ(faces_along(body, Vec3::UnitZ()).faces.size(), 4U);
}

}  // namespace
}  // namespace impinge::lab

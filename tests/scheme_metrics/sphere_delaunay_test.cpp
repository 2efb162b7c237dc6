// SPDX-License-Identifier: GPL-3.0-or-later
// The oracles: closed forms of regular bodies, largest_gap(), which a test of its own compares with all
// triples, and a fine set of probes.
//   rho = max over u of min over entries of angle(u, entry),   sum of areas = 4 pi
#include "scheme_metrics/sphere_delaunay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "sphere/largest_gap.hpp"
#include "sphere/uniform_directions.hpp"

namespace impinge {
namespace {

std::vector<Vec3> octahedron() {
  return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
}

std::vector<Vec3> icosahedron() {
  const double g = std::numbers::phi;
  std::vector<Vec3> u;
  for (const double a : {1.0, -1.0}) {
    for (const double b : {g, -g}) {
      u.push_back(Vec3(0, a, b).normalized());
      u.push_back(Vec3(a, b, 0).normalized());
      u.push_back(Vec3(b, 0, a).normalized());
    }
  }
  return u;
}

double sum(const std::vector<double>& values) {
  double total = 0.0;
  for (const double value : values) total += value;
  return total;
}

std::size_t nearest(const std::vector<Vec3>& entries, const Vec3& u) {
  return static_cast<std::size_t>(
      std::ranges::max_element(entries, {}, [&](const Vec3& e) { return e.dot(u); }) - entries.begin());
}

TEST(SphereDelaunay, OctahedronIsTheClosedForm) {
  const SphereDelaunay delaunay = sphere_delaunay(octahedron());
  ASSERT_EQ(delaunay.triangles.size(), 8U);
  for (const EmptyCircle& gap : delaunay.gaps)
    EXPECT_NEAR(gap.radius, std::acos(1.0 / std::sqrt(3.0)), 1e-15);
  for (const double area : voronoi_areas(delaunay)) EXPECT_NEAR(area, 4.0 * kPi / 6.0, 1e-14);
}

TEST(SphereDelaunay, IcosahedronIsTheClosedForm) {
  const SphereDelaunay delaunay = sphere_delaunay(icosahedron());
  ASSERT_EQ(delaunay.triangles.size(), 20U);
  for (const EmptyCircle& gap : delaunay.gaps)
    EXPECT_NEAR(gap.radius, std::atan(3.0 - std::sqrt(5.0)), 1e-15);
  for (const double area : voronoi_areas(delaunay)) EXPECT_NEAR(area, 4.0 * kPi / 12.0, 1e-14);
}

// Every circle is empty, and the widest is the largest gap.
TEST(SphereDelaunay, WidestCircleIsTheLargestGap) {
  for (std::size_t count : {5U, 8U, 20U, 60U}) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      std::vector<Vec3> entries = octahedron();  // some all round
      for (const Vec3& u : uniform_directions(count, 100 * count + seed)) entries.push_back(u);
      const SphereDelaunay delaunay = sphere_delaunay(entries);
      EXPECT_EQ(delaunay.triangles.size(), 2 * entries.size() - 4);
      for (const EmptyCircle& gap : delaunay.gaps) {
        const double to_nearest = angle_between(gap.centre, entries[nearest(entries, gap.centre)]);
        ASSERT_NEAR(to_nearest, gap.radius, 1e-12);
      }
      EXPECT_NEAR(widest_gap(delaunay).radius, largest_gap(entries, -1.0, kPi), 1e-12);
      for (const double z_max : {0.9, 0.5, 0.1}) {
        double widest = 0.0;
        for (const EmptyCircle& gap : delaunay.gaps) {
          if (std::abs(gap.centre.z()) <= z_max) widest = std::max(widest, gap.radius);
        }
        EXPECT_EQ(widest_gap(delaunay, z_max).radius, widest);
      }
    }
  }
}

TEST(SphereDelaunay, AreasAreTheSharesOfProbesAndSumToTheSphere) {
  constexpr std::size_t probes = 400000;
  std::vector<Vec3> entries = octahedron();
  for (const Vec3& u : uniform_directions(14, 7)) entries.push_back(u);
  const SphereDelaunay delaunay = sphere_delaunay(entries);
  EXPECT_NEAR(sum(voronoi_areas(delaunay)), 4.0 * kPi, 1e-13);
  const std::vector<double> areas = entry_areas(delaunay);
  std::vector<double> hits(entries.size(), 0.0);
  for (const Vec3& u : uniform_directions(probes, 8)) hits[nearest(entries, u)] += 1.0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const double share = areas[i] / (4.0 * kPi);
    const double deviation = std::sqrt(share * (1.0 - share) / static_cast<double>(probes));
    EXPECT_NEAR(hits[i] / static_cast<double>(probes), share, 4.5 * deviation) << i;
  }
}

// Four on one circle, and a ring whose middle is empty: any triangulation gives the same circles and areas.
TEST(SphereDelaunay, DirectionsOnOneCircleAreNoTrouble) {
  std::vector<Vec3> cube;
  for (int k = 0; k < 8; ++k) {
    cube.push_back(Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1).normalized());
  }
  const SphereDelaunay corners = sphere_delaunay(cube);
  EXPECT_NEAR(widest_gap(corners).radius, std::acos(1.0 / std::sqrt(3.0)), 1e-14);
  for (const double area : voronoi_areas(corners)) EXPECT_NEAR(area, 0.5 * kPi, 1e-13);

  std::vector<Vec3> ring{{0, 0, -1}};
  for (int k = 0; k < 360; ++k) ring.push_back(to_direction({0.3, k * kDegree}));
  for (int k = 0; k < 12; ++k) ring.push_back(to_direction({1.8, k * 30.0 * kDegree}));
  const SphereDelaunay rings = sphere_delaunay(ring);
  EXPECT_NEAR(sum(voronoi_areas(rings)), 4.0 * kPi, 1e-12);
  const auto at_pole = std::ranges::count_if(rings.gaps, [](const EmptyCircle& gap) {
    return std::abs(gap.centre.z() - 1.0) < 1e-12 && gap.radius < 0.3 + 1e-9;
  });
  EXPECT_EQ(at_pole, 358);
}

TEST(SphereDelaunay, EntriesOfOneDirectionShareItsArea) {
  std::vector<Vec3> entries = octahedron();
  entries.push_back(entries[4]);
  entries.push_back((entries[4] + Vec3(1e-12, 0, 0)).normalized());
  const SphereDelaunay delaunay = sphere_delaunay(entries);
  EXPECT_EQ(delaunay.distinct.direction.size(), 6U);
  const std::vector<double> areas = entry_areas(delaunay);
  EXPECT_NEAR(areas[0], 4.0 * kPi / 6.0, 1e-13);
  for (const std::size_t i : {4U, 6U, 7U}) EXPECT_NEAR(areas[i], 4.0 * kPi / 18.0, 1e-13);
}

TEST(SphereDelaunay, RefusesWhatDoesNotGoRoundTheSphere) {
  EXPECT_THROW(sphere_delaunay({}), std::invalid_argument);
  const std::vector<Vec3> few{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_THROW(sphere_delaunay(few), std::invalid_argument);
  std::vector<Vec3> half = few;
  half.push_back(Vec3(1, 1, 1).normalized());
  EXPECT_THROW(sphere_delaunay(half), std::invalid_argument);
  std::vector<Vec3> circle;
  for (int k = 0; k < 8; ++k) circle.push_back(to_direction({kPi / 2.0, k * kPi / 4.0}));
  EXPECT_THROW(sphere_delaunay(circle), std::invalid_argument);
  std::vector<Vec3> twice = octahedron();
  twice.push_back(twice[0]);
  EXPECT_THROW(delaunay_triangles(twice), std::invalid_argument);
  std::vector<Vec3> broken = octahedron();
  broken[2].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(sphere_delaunay(broken), std::invalid_argument);
}

TEST(DistinctDirections, KeepsTheOrderOfFirstEntries) {
  const std::vector<Vec3> entries{{0, 0, 1}, {1, 0, 0}, {0, -0.0, 1}, {0, 1, 0}, {1, 1e-16, 0}};
  const DistinctDirections distinct = distinct_directions(entries);
  EXPECT_EQ(distinct.of_entry, (std::vector<std::size_t>{0, 1, 0, 2, 1}));
  EXPECT_EQ(distinct.entries, (std::vector<std::size_t>{2, 2, 1}));
  EXPECT_EQ(distinct.direction[2], entries[3]);
}

}  // namespace
}  // namespace impinge

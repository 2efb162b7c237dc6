// SPDX-License-Identifier: GPL-3.0-or-later
// The `mesh_exact` interpolant, for every scheme of the generated list that claims it:
//   x / depth(x) = sum w_i u_i / depth(u_i),  r(x) = |x| / (depth(x) sum w_i / (r_i depth(u_i)))
//   a plane is reproduced at any incidence angle;  R (1 - rho^2 / 2) <= r <= R for a sphere
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sphere/scheme_list.hpp"
#include "sphere/stored_table.hpp"
#include "support/directions.hpp"
#include "support/every_scheme.hpp"

namespace impinge {
namespace {

constexpr double kRounding = 12.0 * 0x1p-53;  // relative, at psi = 0
constexpr double kMostError = 1e-13;          // relative, at 89 degrees

// A plane n . x = distance, n a unit vector.
struct Plane {
  Vec3 normal;
  double distance;  // mm
  double radius(const Vec3& u) const { return distance / normal.dot(u); }
};

template <class Visit>
void for_each_plane_exact_scheme(Visit&& visit) {
  test::every_scheme([&]<class S>() {
    if constexpr (PlaneExactScheme<S>) visit.template operator()<S>();
  });
}

// Does the ray along u meet the plane, at more than 0.06 degrees?
bool meets(const Plane& plane, const Vec3& u) { return plane.normal.dot(u) > 1e-3; }

template <SamplingScheme S>
bool is_covered(const Plane& plane, const S& scheme, const Stencil& stencil) {
  return std::all_of(stencil.entry.begin(), stencil.entry.begin() + stencil.taps,
                     [&](std::size_t i) { return meets(plane, scheme.direction(i)); });
}

template <SamplingScheme S>
RadialTable<S> table_of(const S& scheme, const Plane& plane) {
  RadialTable<S> table(scheme);
  for (std::size_t i = 0; i < scheme.size(); ++i) {
    const Vec3 u = scheme.direction(i);
    if (meets(plane, u)) table.radii()[i] = plane.radius(u);
  }
  return table;
}

TEST(InverseDepthTable, SomeSchemesClaimIt) {
  int claims = 0;
  for_each_scheme([&claims]<class S>() { claims += PlaneExactScheme<S> ? 1 : 0; });
  EXPECT_GE(claims, 4);
}

TEST(InverseDepthTable, WeightsPutThePointOfTheSolidBetweenItsTaps) {
  for_each_plane_exact_scheme([]<class S>() {
    for (const double precision : {90.0, 24.0, 1.0}) {
      const S scheme = S::with_precision(precision);
      auto probes = test::random_directions(10000, 90);
      for (const Vec3& x : test::special_directions()) probes.push_back(x);
      for (std::size_t i = 0; i < std::min<std::size_t>(scheme.size(), 2000); ++i)
        probes.push_back(scheme.direction(i));
      for (const Vec3& x : probes) {
        const Stencil smooth = scheme.stencil(x);
        const Stencil plane = scheme.plane_stencil(x);
        if (S::kFlatCells) {
          ASSERT_EQ(plane.cell, smooth.cell) << S::name;
          ASSERT_EQ(plane.entry, smooth.entry) << S::name;
        }
        Vec3 between = Vec3::Zero();
        double sum = 0.0;
        for (std::size_t k = 0; k < plane.taps; ++k) {
          ASSERT_GE(plane.weight[k], 0.0) << S::name;
          const Vec3 tap = scheme.direction(plane.entry[k]);
          between += plane.weight[k] * tap / scheme.depth(tap);
          sum += plane.weight[k];
        }
        ASSERT_NEAR(sum, 1.0, 4e-16) << S::name;
        ASSERT_LT((between - x / scheme.depth(x)).norm(), 4e-15) << S::name << " at " << x.transpose();
      }
    }
  });
}

// In the middle of the taps stand the same taps and cell; only beside a curved border is it not that of the
// direction.
TEST(InverseDepthTable, TapsAreTheCornersOfTheCell) {
  for_each_plane_exact_scheme([]<class S>() {
    const S scheme = S::with_precision(10.0);
    int beside = 0;
    for (const Vec3& u : test::random_directions(20000, 97)) {
      const Stencil plane = scheme.plane_stencil(u);
      Vec3 middle = Vec3::Zero();
      for (std::size_t k = 0; k < plane.taps; ++k) middle += scheme.direction(plane.entry[k]);
      const Stencil there = scheme.stencil(middle);
      ASSERT_EQ(there.cell, plane.cell) << S::name;
      ASSERT_EQ(there.entry, plane.entry) << S::name;
      beside += plane.cell == scheme.stencil(u).cell ? 0 : 1;
    }
    EXPECT_EQ(beside == 0, S::kFlatCells) << S::name;
    EXPECT_LT(beside, 1000) << S::name;
  });
}

TEST(InverseDepthTable, DepthIsThatOfAConvexSolid) {
  for_each_plane_exact_scheme([]<class S>() {
    const S scheme;
    const auto u = test::random_directions(1000, 91);
    for (std::size_t k = 0; k + 1 < u.size(); ++k) {
      EXPECT_GT(scheme.depth(u[k]), 0.0) << S::name;
      EXPECT_NEAR(scheme.depth(7.0 * u[k]), 7.0 * scheme.depth(u[k]), 1e-14) << S::name;
      EXPECT_LE(scheme.depth(u[k] + u[k + 1]), (scheme.depth(u[k]) + scheme.depth(u[k + 1])) * (1 + 1e-15))
          << S::name;
    }
  });
}

// The radius of a plane, n.v / n.u, is itself uncertain by 2^-53 / cos(psi): of the taps and of the truth.
TEST(InverseDepthTable, AnyPlaneIsReproducedAtAnyIncidence) {
  for_each_plane_exact_scheme([]<class S>() {
    const S scheme = S::with_precision(0.8);
    const auto normals = test::random_directions(4, 92);
    const auto around = test::random_directions(2000, 93);
    for (const Vec3& normal : normals) {
      const Plane plane{normal, 20.0};
      const InverseDepthTable<S> table(table_of(scheme, plane));
      for (std::size_t k = 0; k < around.size(); ++k) {
        const double psi = std::array{0.0, 10.0, 45.0, 60.0, 80.0, 88.0, 89.0}[k % 7] * kDegree;
        const Vec3 across = (around[k] - around[k].dot(normal) * normal).normalized();
        const Vec3 u = (std::cos(psi) * normal + std::sin(psi) * across).normalized();
        if (!is_covered(plane, scheme, scheme.plane_stencil(u))) continue;
        const double exact = plane.radius(u);
        ASSERT_NEAR(table.radius_at(u), exact, std::min(kMostError, kRounding / std::cos(psi)) * exact)
            << S::name << " psi " << psi / kDegree;
      }
    }
  });
}

// The bilinear patch or flat triangle lies inside of the sphere, nowhere deeper than R rho^2 / 2.
TEST(InverseDepthTable, ASphereBecomesItsChords) {
  for_each_plane_exact_scheme([]<class S>() {
    const S scheme = S::with_precision(4.0);
    RadialTable<S> smooth(scheme);
    std::ranges::fill(smooth.radii(), 24.0);
    const InverseDepthTable<S> table(smooth);
    const double bound = 12.0 * scheme.covering_radius() * scheme.covering_radius();
    double deepest = 0.0;
    for (const Vec3& u : test::random_directions(50000, 94)) {
      const double radius = table.radius_at(u);
      ASSERT_LE(radius, 24.0 * (1.0 + 4e-16)) << S::name;
      deepest = std::max(deepest, 24.0 - radius);
      ASSERT_NEAR(smooth.radius_at(u), 24.0, 1e-14) << S::name;
    }
    EXPECT_LE(deepest, bound) << S::name;
    EXPECT_GE(deepest, 0.97 * bound) << S::name;
  });
}

TEST(InverseDepthTable, RadiusDoesNotDependOnTheLengthOfTheDirection) {
  for_each_plane_exact_scheme([]<class S>() {
    const S scheme = S::with_precision(4.0);
    const InverseDepthTable<S> table(table_of(scheme, {Vec3::UnitX(), 20.0}));
    for (const Vec3& u : test::random_directions(2000, 95)) {
      if (u.x() < 0.2) continue;
      EXPECT_EQ(table.radius_at(u), table.radius_at(std::ldexp(1.0, 600) * u)) << S::name;
      EXPECT_NEAR(table.radius_at(u), table.radius_at(3e-5 * u), 1e-13) << S::name;
    }
  });
}

// As in RadialTable: no tap reaches across a rim, a tap without surface counts unless its weight is zero.
TEST(InverseDepthTable, MissingSurfaceIsThatOfTheRadialTable) {
  for_each_plane_exact_scheme([]<class S>() {
    const S scheme = S::with_precision(10.0);
    RadialTable<S> radii(scheme);
    std::ranges::fill(radii.radii(), 5.0);
    const Vec3 rim = Vec3(0.3, -0.5, 0.7).normalized();
    const Vec3 hole = Vec3(-0.6, 0.5, 0.2).normalized();
    radii.mark_rim_cell(scheme.stencil(rim).cell);
    radii.radii()[scheme.plane_stencil(hole).entry[1]] = kNoSurface;
    const InverseDepthTable<S> table(radii);
    EXPECT_TRUE(std::isnan(table.radius_at(rim))) << S::name;
    EXPECT_TRUE(std::isnan(table.radius_at(hole))) << S::name;
    const Vec3 entry = scheme.direction(scheme.plane_stencil(hole).entry[0]);
    EXPECT_EQ(std::isnan(table.radius_at(entry)), std::isnan(radii.radius_at(entry))) << S::name;
    int missing = 0;
    for (const Vec3& u : test::random_directions(5000, 96)) {
      if (S::kFlatCells || radii.is_rim_cell(scheme.stencil(u).cell)) {
        ASSERT_EQ(std::isnan(table.radius_at(u)), std::isnan(radii.radius_at(u))) << S::name;
      }
      missing += std::isnan(table.radius_at(u)) ? 1 : 0;
    }
    EXPECT_GT(missing, 10) << S::name;
  });
}

// Beside a curved border a rim in either cell, that of the direction and that of the taps, may part them.
TEST(InverseDepthTable, ARimInEitherCellCounts) {
  for_each_plane_exact_scheme([]<class S>() {
    const S scheme = S::with_precision(10.0);
    int beside = 0;
    for (const Vec3& u : test::random_directions(20000, 98)) {
      const std::array<std::size_t, 2> cells{scheme.stencil(u).cell, scheme.plane_stencil(u).cell};
      if (cells[0] == cells[1] || ++beside > 20) continue;
      for (const std::size_t cell : cells) {
        RadialTable<S> radii(scheme);
        std::ranges::fill(radii.radii(), 5.0);
        EXPECT_FALSE(std::isnan(InverseDepthTable<S>(radii).radius_at(u))) << S::name;
        radii.mark_rim_cell(cell);
        EXPECT_TRUE(std::isnan(InverseDepthTable<S>(radii).radius_at(u))) << S::name;
      }
    }
    EXPECT_EQ(beside == 0, S::kFlatCells) << S::name;
  });
}

}  // namespace
}  // namespace impinge

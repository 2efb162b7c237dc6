// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every sampling scheme, over the generated list:
//   sum w_i = 1, w_i >= 0        a constant is reproduced
//   angle(u, tap) <= stencil radius,  min over entries <= covering radius
//   a cell has one stencil, the interpolation is continuous
//   entries inside a spherical triangle = those of brute force
//   areas a_i > 0, sum a_i = 4 pi, sum a_i u_i = 0, sum a_i z_i^2 = 4 pi / 3    where a scheme declares them
// (Planes: inverse_depth_table_test.cpp.)
#include "sphere/scheme.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sphere/radial_table.hpp"
#include "sphere/scheme_choice.hpp"
#include "sphere/walker.hpp"
#include "support/covering.hpp"
#include "support/directions.hpp"
#include "support/every_scheme.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

constexpr double kCoarse = 10.0;  // degrees; small enough for brute force over all entries

// Random ones, poles, axes, seam, and rings ever nearer to the poles: there are the first and the last turn,
// row or ring of every scheme.
std::vector<Vec3> probes() {
  std::vector<Vec3> u = test::random_directions(20000, 7);
  for (double phi = 1e-9; phi < 0.3; phi *= 1.7) {
    for (double theta = 0.0; theta < 2.0 * kPi; theta += 0.3) {
      u.push_back(to_direction({phi, theta}));
      u.push_back(-u.back());
    }
  }
  for (const Vec3& x : test::special_directions()) u.push_back(x.normalized());
  return u;
}

TEST(Scheme, WeightsSumToOneAndTapsExist) {
  test::every_scheme([]<class S>() {
    const S scheme = S::with_precision(1.0);
    for (const Vec3& u : probes()) {
      const Stencil stencil = scheme.stencil(u);
      double sum = 0.0;
      for (std::size_t k = 0; k < stencil.taps; ++k) {
        ASSERT_GE(stencil.weight[k], 0.0) << S::name;
        ASSERT_LT(stencil.entry[k], scheme.size()) << S::name;
        sum += stencil.weight[k];
      }
      ASSERT_NEAR(sum, 1.0, 4e-16) << S::name << " at " << u.transpose();
      ASSERT_LT(stencil.cell, scheme.cells()) << S::name;
    }
  });
}

TEST(Scheme, AConstantIsReproduced) {
  test::every_scheme([]<class S>() {
    for (const double precision : {30.0, 1.0}) {
      RadialTable<S> table(S::with_precision(precision));
      std::ranges::fill(table.radii(), 24.0);
      for (const Vec3& u : probes()) ASSERT_NEAR(table.radius_at(u), 24.0, 2e-14) << S::name;
    }
  });
}

TEST(Scheme, TapsAreWithinTheStencilRadius) {
  test::every_scheme([]<class S>() {
    for (const double precision : {30.0, 5.0, 0.5}) {
      const S scheme = S::with_precision(precision);
      for (const Vec3& u : probes()) {
        const Stencil stencil = scheme.stencil(u);
        for (std::size_t k = 0; k < stencil.taps; ++k) {
          ASSERT_LE(angle_between(u, scheme.direction(stencil.entry[k])),
                    scheme.stencil_radius() * (1 + 1e-12))
              << S::name << " at " << u.transpose();
        }
      }
    }
  });
}

// Seams and poles included: a small step changes the value of a smooth table little.
TEST(Scheme, InterpolationIsContinuous) {
  test::every_scheme([]<class S>() {
    const S scheme = S::with_precision(12.0);
    RadialTable<S> table(scheme);
    for (std::size_t i = 0; i < scheme.size(); ++i) table.radii()[i] = 10.0 + scheme.direction(i).sum();
    for (const Vec3& u : test::random_directions(20000, 83)) {
      const Vec3 v = (u + 1e-9 * u.unitOrthogonal()).normalized();
      ASSERT_NEAR(table.radius_at(u), table.radius_at(v), 1e-7) << S::name << " at " << u.transpose();
    }
  });
}

TEST(Scheme, ACellHasOneStencil) {
  test::every_scheme([]<class S>() {
    for (const double precision : {45.0, 15.0, 3.0}) {
      const S scheme = S::with_precision(precision);
      std::vector<Stencil> seen(scheme.cells());
      for (const Vec3& u : test::random_directions(100000, 72)) {
        Stencil stencil = scheme.stencil(u);
        std::sort(stencil.entry.begin(), stencil.entry.begin() + stencil.taps);
        Stencil& first = seen[stencil.cell];
        if (first.taps == 0) first = stencil;
        ASSERT_EQ(first.entry, stencil.entry) << S::name << " cell " << stencil.cell;
      }
    }
  });
}

TEST(Scheme, RadiiHoldForFewEntries) {
  test::every_scheme([]<class S>() {
    for (double n = 2.0; n < 20.0; n += 1.0) {
      const auto scheme = scheme_of_precision<S>(180.0 / n);
      if (!scheme) continue;
      for (const Vec3& u : test::random_directions(5000, 54)) {
        const Stencil stencil = scheme->stencil(u);
        for (std::size_t k = 0; k < stencil.taps; ++k) {
          ASSERT_LE(angle_between(u, scheme->direction(stencil.entry[k])),
                    scheme->stencil_radius() * (1.0 + 1e-12))
              << S::name << ' ' << n;
        }
      }
      const double gap = test::climbed_gap(*scheme, 1.0, 1000, 85);
      EXPECT_LE(gap, scheme->covering_radius() * (1.0 + 1e-12)) << S::name << ' ' << n;
      EXPECT_GE(gap, 0.75 * scheme->covering_radius()) << S::name << ' ' << n;
    }
  });
}

TEST(Scheme, FineTablesAreDescribedWithoutBeingMade) {
  const Vec3 u = Vec3(0.3, -0.8, 0.1).normalized();
  test::every_scheme([&u]<class S>() {
    for (const double precision : {1e-3, 1e-4, 1e-5, 1e-6}) {
      const auto scheme = scheme_of_precision<S>(precision);
      if (!scheme) continue;
      const Stencil stencil = scheme->stencil(u);
      for (std::size_t k = 0; k < stencil.taps; ++k) {
        EXPECT_LE(angle_between(u, scheme->direction(stencil.entry[k])),
                  scheme->stencil_radius() * (1.0 + 1e-6))
            << S::name << ' ' << precision;
      }
    }
  });
}

// Which may be any above zero, for the same bits.
TEST(Scheme, StencilDoesNotDependOnLength) {
  test::every_scheme([]<class S>() {
    const S scheme = S::with_precision(1.0);
    for (const Vec3& u : test::random_directions(500, 8)) {
      const Stencil expected = scheme.stencil(u);
      for (const int exponent : {-500, -100, 3, 30, 100, 500}) {
        const Stencil found = scheme.stencil(std::ldexp(1.0, exponent) * u);
        ASSERT_EQ(found.cell, expected.cell) << S::name << ' ' << exponent;
        ASSERT_EQ(found.entry, expected.entry) << S::name << ' ' << exponent;
        ASSERT_EQ(found.weight, expected.weight) << S::name << ' ' << exponent;
      }
    }
  });
}

TEST(Scheme, DirectionsOfEntriesRoundTrip) {
  test::every_scheme([]<class S>() {
    const S scheme = S::with_precision(kCoarse);
    for (std::size_t i = 0; i < scheme.size(); ++i) {
      const Vec3 u = scheme.direction(i);
      ASSERT_NEAR(u.norm(), 1.0, 4e-16) << S::name;
      const Stencil stencil = scheme.stencil(u);
      double at_entry = 0.0;  // weight of taps that are this direction; poles may have several entries
      for (std::size_t k = 0; k < stencil.taps; ++k) {
        if ((scheme.direction(stencil.entry[k]) - u).norm() < 1e-12) at_entry += stencil.weight[k];
      }
      ASSERT_NEAR(at_entry, 1.0, 1e-12)
          << S::name << " entry " << i << ": the stencil of its direction reads other entries. Schemes whose"
          << " parts overlap (overset grids) cannot be used, see sphere/scheme.hpp";
    }
  });
}

TEST(Scheme, EveryDirectionIsWithinTheCoveringRadius) {
  test::every_scheme([]<class S>() {
    const S scheme = S::with_precision(kCoarse);
    std::vector<Vec3> entries;
    for (std::size_t i = 0; i < scheme.size(); ++i) entries.push_back(scheme.direction(i));
    double farthest = 0.0;
    // With poles and axes, where the largest gap of a scheme may be.
    std::vector<Vec3> directions = test::random_directions(20000, 9);
    for (const Vec3& x : test::special_directions()) directions.push_back(x.normalized());
    for (const Vec3& u : directions) {
      double nearest = kPi;
      for (const Vec3& e : entries) nearest = std::min(nearest, (u - e).squaredNorm());
      farthest = std::max(farthest, 2.0 * std::asin(std::sqrt(nearest) / 2.0));
    }
    EXPECT_LE(farthest, scheme.covering_radius() * (1.0 + 1e-12)) << S::name;
    // The largest gap may be in one place only, which random directions miss by a few per cent.
    farthest = std::max(farthest, test::climbed_gap(scheme, 1.0, 5000, 9));
    EXPECT_LE(farthest, scheme.covering_radius() * (1.0 + 1e-12)) << S::name;
    EXPECT_GE(farthest, 0.97 * scheme.covering_radius()) << S::name << ": the declared radius is too large";
  });
}

TEST(Scheme, AreasArePositiveAndSumToTheSphere) {
  static_assert(AreaScheme<Rsid>);
  test::every_scheme([]<class S>() {
    if constexpr (AreaScheme<S>) {
      for (const double precision : {60.0, 10.0, 1.0}) {
        const S scheme = S::with_precision(precision);
        double sum = 0.0;
        Vec3 first = Vec3::Zero();
        double second = 0.0;
        for (std::size_t i = 0; i < scheme.size(); ++i) {
          ASSERT_GT(scheme.area(i), 0.0) << S::name << " entry " << i;
          const Vec3 u = scheme.direction(i);
          sum += scheme.area(i);
          first += scheme.area(i) * u;
          second += scheme.area(i) * u.z() * u.z();
        }
        EXPECT_NEAR(sum, 4.0 * kPi, 4.0 * kPi * 1e-12) << S::name;
        // The moments are those of a sum over points, of the order of the square of their distance.
        const double error = 4.0 * kPi * scheme.covering_radius() * scheme.covering_radius();
        EXPECT_LT(first.norm(), error) << S::name << ' ' << precision;
        EXPECT_NEAR(second, 4.0 * kPi / 3.0, error) << S::name << ' ' << precision;
      }
    }
  });
}

// A walker, the scheme's own or that of any scheme, finds what a loop over all entries finds: once each, with
// the numbers of direction().
TEST(Scheme, EntriesInsideATriangleAreThoseOfBruteForce) {
  const auto u = test::random_directions(300, 10);
  std::vector<TriangleCone> cones;
  for (std::size_t k = 0; k + 2 < u.size(); k += 3) {
    const double size = std::pow(10.0, -static_cast<double>(k % 5) / 2.0);
    cones.emplace_back(u[k], (u[k] + size * u[k + 1]).normalized(), (u[k] + size * u[k + 2]).normalized());
  }
  cones.emplace_back(Vec3(0, 0, 1), Vec3(1, 0, 0),
                     Vec3(0, 1, 0));  // an octant: edges on grid lines, pole a corner
  cones.emplace_back(Vec3(-1, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 1));
  cones.emplace_back(Vec3(1, -0.5, 0), Vec3(1, 0.5, 0), Vec3(1, 0, 1));  // across the seam
  cones.emplace_back(Vec3(-1, -1, -1), Vec3(1, -1, -1), Vec3(0, 1, -1));
  test::every_scheme([&]<class S>() {
    const S scheme = S::with_precision(5.0);
    const auto check = [&](const auto& walker, const TriangleCone& cone) {
      std::multiset<std::size_t> found;
      for_each_entry_inside(walker, cone, [&](std::size_t i, const Vec3& direction) {
        found.insert(i);
        ASSERT_EQ(direction, scheme.direction(i)) << S::name;
      });
      std::multiset<std::size_t> expected;
      for (std::size_t i = 0; i < scheme.size(); ++i) {
        if (cone.contains(scheme.direction(i))) expected.insert(i);
      }
      ASSERT_EQ(found, expected) << S::name;
    };
    const WalkerTree tree(scheme);
    for (const TriangleCone& cone : cones) {
      if (cone.edge_on()) continue;
      check(walker_of(scheme), cone);
      check(tree, cone);
    }
  });
}

TEST(Scheme, WalkerFindsEntriesWithinAMargin) {
  const auto u = test::random_directions(90, 11);
  test::every_scheme([&]<class S>() {
    const S scheme = S::with_precision(5.0);
    for (std::size_t k = 0; k + 2 < u.size(); k += 3) {
      const TriangleCone cone(u[k], (u[k] + 0.2 * u[k + 1]).normalized(),
                              (u[k] + 0.2 * u[k + 2]).normalized());
      const auto check = [&](const auto& walker) {
        std::set<std::size_t> found;
        walker.visit_near(cone, 0.1, [&](const DirectionRun& run) {
          for (std::size_t i = 0; i < run.count; ++i) found.insert(run.first + i);
        });
        for (std::size_t i = 0; i < scheme.size(); ++i) {
          const bool near_corner = std::ranges::any_of(
              cone.corners(), [&](const Vec3& v) { return angle_between(v, scheme.direction(i)) < 0.1; });
          if (near_corner || cone.contains(scheme.direction(i))) {
            ASSERT_TRUE(found.contains(i)) << S::name;
          }
        }
      };
      check(walker_of(scheme));
      check(WalkerTree(scheme));
    }
  });
}

TEST(Scheme, RefusesPrecisionsThatMakeNoSense) {
  test::every_scheme([]<class S>() {
    for (const double precision : {0.0, -1.0, std::nan(""), HUGE_VAL, 1e-300}) {
      EXPECT_THROW(S::with_precision(precision), std::invalid_argument) << S::name << ' ' << precision;
    }
  });
}

TEST(SchemeChoice, FindsEachNameAndNamesAllWhenItDoesNot) {
  test::every_scheme([]<class S>() {
    std::string found;
    with_scheme(S::name, [&found]<class T>() { found = T::name; });
    EXPECT_EQ(found, S::name);
    EXPECT_NE(scheme_names().find(S::name), std::string::npos);
  });
  EXPECT_EQ(test::thrown<std::invalid_argument>([] { with_scheme("rside", []<class>() { FAIL(); }); }),
            "unknown scheme 'rside'; there are " + scheme_names());
}

}  // namespace
}  // namespace impinge

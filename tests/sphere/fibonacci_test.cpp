// SPDX-License-Identifier: GPL-3.0-or-later
// Fibonacci lattice: theta = 2 pi i / golden ratio, z = 1 - 2 (i + 1/4) / (N - 1/2).
#include "sphere/schemes/fibonacci.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "support/covering.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

TEST(Fibonacci, EntriesStandOnTheLattice) {
  const Fibonacci lattice = Fibonacci::with_precision(1.0);
  EXPECT_EQ(lattice.size(), 41253U);
  EXPECT_EQ(lattice.equator_points(), 360U);
  EXPECT_NEAR(test::covering_constant(lattice, lattice.covering_radius()), 6.73, 0.02);
  const long double golden = (1.0L + std::sqrt(5.0L)) / 2.0L;
  for (std::size_t i = 0; i < lattice.size(); i += 17) {
    const long double turns = static_cast<long double>(i) / golden;
    const long double theta = 2.0L * static_cast<long double>(kPi) * (turns - std::floor(turns));
    const long double z = 1.0L - 2.0L * (static_cast<long double>(i) + 0.25L) / 41252.5L;
    const long double s = std::sqrt(1.0L - z * z);
    const Vec3 expected(static_cast<double>(s * std::cos(theta)), static_cast<double>(s * std::sin(theta)),
                        static_cast<double>(z));
    ASSERT_LT((lattice.direction(i) - expected).norm(), 1e-13) << i;
  }
}

// The triangle that holds u is a Delaunay one: no entry is inside of its circle. All sizes, poles included.
TEST(Fibonacci, TheStencilIsTheDelaunayTriangle) {
  for (const double precision : {60.0, 30.0, 15.0, 7.0, 4.0}) {
    const Fibonacci lattice = Fibonacci::with_precision(precision);
    std::vector<Vec3> entries;
    for (std::size_t i = 0; i < lattice.size(); ++i) entries.push_back(lattice.direction(i));
    for (const Vec3& u : test::random_directions(5000, 81)) {
      const Stencil stencil = lattice.stencil(u);
      ASSERT_EQ(stencil.taps, 3U);
      const std::array<Vec3, 3> corner{entries[stencil.entry[0]], entries[stencil.entry[1]],
                                       entries[stencil.entry[2]]};
      const Vec3 centre = circumcentre(corner[0], corner[1], corner[2]);
      for (const Vec3& e : entries) ASSERT_LT(centre.dot(e), centre.dot(corner[0]) + 1e-12);
      Vec3 inside = Vec3::Zero();
      for (std::size_t k = 0; k < 3; ++k) inside += stencil.weight[k] * corner[k];
      ASSERT_LT(angle_between(inside, u), 1e-12);
    }
  }
}

// The faces of a triangulation.
TEST(Fibonacci, ATriangleHasOneCell) {
  for (const double precision : {60.0, 30.0, 12.0}) {
    const Fibonacci lattice = Fibonacci::with_precision(precision);
    std::set<std::size_t> cells;
    for (const Vec3& u : test::random_directions(100000, 82)) cells.insert(lattice.stencil(u).cell);
    EXPECT_EQ(cells.size(), 2 * lattice.size() - 4);
  }
}

TEST(Fibonacci, RefusesWhatItCannotCount) {
  EXPECT_THROW(Fibonacci::with_precision(61.0), std::invalid_argument);
  EXPECT_THROW(Fibonacci::with_precision(1e-4), std::invalid_argument);
}

}  // namespace
}  // namespace impinge

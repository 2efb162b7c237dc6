// SPDX-License-Identifier: GPL-3.0-or-later
// HEALPix, RING order: N rho^2 -> 8, the poles being farthest from the entries.
#include "sphere/schemes/healpix.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "sphere/largest_gap.hpp"
#include "support/directions.hpp"
#include "support/ring_order.hpp"

namespace impinge {
namespace {

Healpix of_nside(std::size_t nside) { return Healpix::with_precision(90.0 / static_cast<double>(nside)); }

// Values of pix2ang() in the documentation of healpy.
TEST(Healpix, EntriesAreThoseOfTheHealpixSoftware) {
  struct Known {
    std::size_t nside, entry;
    double phi, theta;
  };
  for (const auto& [nside, entry, phi, theta] :
       {Known{16, 1440, 1.5291175943723188, 0.0}, Known{16, 427, 0.78550497, 0.78539816},
        Known{16, 1520, 1.57079633, 1.61988371}, Known{16, 0, 0.05103658, 0.78539816},
        Known{16, 3068, 3.09055608, 0.78539816}, Known{1, 11, 2.30052398, 5.49778714},
        Known{2, 11, 0.84106867, 5.89048623}, Known{4, 11, 0.41113786, 5.89048623},
        Known{8, 11, 0.2044802, 5.89048623}}) {
    const Angles found = to_angles(of_nside(nside).direction(entry));
    EXPECT_NEAR(found.phi, phi, 1e-8) << nside << ' ' << entry;
    EXPECT_NEAR(found.theta, theta, 1e-8) << nside << ' ' << entry;
  }
}

// Values of get_interp_weights() in the documentation of healpy: a quarter each at the pole, one entry at
// (90, 0) degrees.
TEST(Healpix, WeightsAreThoseOfTheHealpixSoftware) {
  const Stencil pole = of_nside(1).stencil({0, 0, 1});
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_LT(pole.entry[k], 4U);
    EXPECT_EQ(pole.weight[k], 0.25);
  }
  const Stencil equator = of_nside(1).stencil({1, 0, 0});
  double at_entry = 0.0;
  for (std::size_t k = 0; k < 4; ++k) at_entry += equator.entry[k] == 4 ? equator.weight[k] : 0.0;
  EXPECT_NEAR(at_entry, 1.0, 1e-15);
}

TEST(Healpix, RingsFollowOneAnother) {
  for (const std::size_t nside : {1U, 2U, 3U, 18U}) test::expect_rings_in_order(of_nside(nside));
}

TEST(Healpix, CoveringRadiusIsTheLargestGap) {
  for (const std::size_t nside : {1U, 2U, 3U, 4U, 9U, 12U}) {
    const Healpix scheme = of_nside(nside);
    std::vector<Vec3> entries;
    for (std::size_t i = 0; i < scheme.size(); ++i) entries.push_back(scheme.direction(i));
    EXPECT_NEAR(largest_gap(entries, -1.0, 1.2 * scheme.covering_radius()), scheme.covering_radius(), 1e-12);
  }
}

TEST(Healpix, CoveringConstantIsEight) {
  const Healpix scheme = of_nside(66);
  EXPECT_EQ(scheme.size(), 52272U);
  EXPECT_NEAR(static_cast<double>(scheme.size()) * scheme.covering_radius() * scheme.covering_radius(), 8.0,
              1e-3);
}

// for_each_cell_across(): the cells that share a gap with this one, found by trying directions.
TEST(Healpix, CellsAcrossShareAGap) {
  for (const std::size_t nside : {1U, 2U, 5U}) {
    const Healpix scheme = of_nside(nside);
    const auto upper = [](const Stencil& s) { return std::array{s.entry[0], s.entry[1]}; };
    const auto lower = [](const Stencil& s) { return std::array{s.entry[2], s.entry[3]}; };
    const auto probes = test::random_directions(100000, 70);
    std::vector<Stencil> cell(scheme.cells());
    for (const Vec3& u : probes) {
      const Stencil stencil = scheme.stencil(u);
      cell[stencil.cell] = stencil;
    }
    for (const Stencil& here : cell) {
      if (here.taps == 0 || here.cell == 0 || here.cell == scheme.cells() - 1) continue;
      std::set<std::size_t> expected;
      for (const Stencil& other : cell) {
        if (other.taps == 0 || other.cell == 0 || other.cell == scheme.cells() - 1) continue;
        const bool same_rings = scheme.direction(other.entry[0]).z() == scheme.direction(here.entry[0]).z();
        if (same_rings && (upper(other) == upper(here) || lower(other) == lower(here)))
          expected.insert(other.cell);
      }
      std::set<std::size_t> found;
      scheme.for_each_cell_across(here, [&](const Stencil& other) { found.insert(other.cell); });
      EXPECT_EQ(found, expected) << nside << " cell " << here.cell;
    }
  }
}

TEST(Healpix, FineGridsAreCheapToMake) {
  const Healpix scheme = Healpix::with_precision(1e-5);
  const Vec3 u = Vec3(0.3, -0.8, 0.1).normalized();
  for (const std::size_t i : scheme.stencil(u).entry)
    EXPECT_LE(angle_between(u, scheme.direction(i)), scheme.stencil_radius());
}

}  // namespace
}  // namespace impinge

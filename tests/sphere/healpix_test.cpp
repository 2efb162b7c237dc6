// SPDX-License-Identifier: GPL-3.0-or-later
// HEALPix, RING order: N rho^2 -> 8, the poles being farthest from the entries.
#include "sphere/schemes/healpix.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "sphere/largest_gap.hpp"

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

TEST(Healpix, CoveringRadiusIsTheLargestGap) {
  for (const std::size_t nside : {1U, 2U, 3U, 4U, 9U, 12U}) {
    const Healpix scheme = of_nside(nside);
    std::vector<Vec3> entries;
    for (std::size_t i = 0; i < scheme.size(); ++i) entries.push_back(scheme.direction(i));
    EXPECT_NEAR(largest_gap(entries, -1.0, 1.2 * scheme.covering_radius()), scheme.covering_radius(), 1e-12);
  }
}

}  // namespace
}  // namespace impinge

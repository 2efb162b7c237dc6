// SPDX-License-Identifier: GPL-3.0-or-later
// HEALPix: N rho^2 -> 8, the poles being farthest from the entries. (tests/healpix holds entries and look-ups
// against libhealpix.)
#include "sphere/schemes/healpix.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "sphere/largest_gap.hpp"

namespace impinge {
namespace {

Healpix of_nside(std::size_t nside) { return Healpix::with_precision(90.0 / static_cast<double>(nside)); }

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

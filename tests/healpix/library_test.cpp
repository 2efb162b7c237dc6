// SPDX-License-Identifier: GPL-3.0-or-later
// Our HEALPix against libhealpix (Gorski et al. 2005), RING order: the same entries, the same lookup.
//
// By design ours takes a vector where get_interpol() takes angles, and keeps weights from 0 to 1 where the
// library's ring, found from cos(theta), is one off by rounding; both differ by rounding alone.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include <gtest/gtest.h>
#include <healpix_base.h>

#include "sphere/schemes/healpix.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

const std::vector<std::size_t> kLarge{100, 333, 1000, 1024, 8191, 65536};

struct Both {
  explicit Both(std::size_t nside)
      : ours(Healpix::with_precision(90.0 / static_cast<double>(nside))),
        theirs(static_cast<std::int64_t>(nside), RING, SET_NSIDE) {}

  Healpix ours;
  Healpix_Base2 theirs;
};

Vec3 pixel_centre(const Healpix_Base2& base, std::size_t i) {
  const vec3 v = base.pix2vec(static_cast<std::int64_t>(i));
  return {v.x, v.y, v.z};
}

std::size_t pixel_of(const Healpix_Base2& base, const Vec3& u) {
  return static_cast<std::size_t>(base.vec2pix(vec3(u.x(), u.y(), u.z())));
}

// Weight of each entry that a lookup reads.
using Weights = std::map<std::size_t, double>;

Weights weights(const Healpix& scheme, const Vec3& u) {
  Weights found;
  const Stencil stencil = scheme.stencil(u);
  for (std::size_t k = 0; k < stencil.taps; ++k) found[stencil.entry[k]] += stencil.weight[k];
  return found;
}

Weights weights(const Healpix_Base2& base, const Vec3& u) {
  const Angles angles = to_angles(u);
  fix_arr<int64, 4> pixel;
  fix_arr<double, 4> weight;
  base.get_interpol(pointing(angles.phi, angles.theta), pixel, weight);
  Weights found;
  for (std::size_t k = 0; k < 4; ++k) found[static_cast<std::size_t>(pixel[k])] += weight[k];
  return found;
}

double largest_difference(Weights a, const Weights& b) {
  for (const auto& [entry, weight] : b) a[entry] -= weight;
  double largest = 0.0;
  for (const auto& [entry, weight] : a) largest = std::max(largest, std::abs(weight));
  return largest;
}

void expect_same_entry(const Both& both, std::size_t i) {
  const Vec3 u = both.ours.direction(i);
  // Rounding of their azimuth, up to 2 pi.
  ASSERT_LT((u - pixel_centre(both.theirs, i)).norm(), 4e-15) << both.ours.nside() << " entry " << i;
  ASSERT_EQ(pixel_of(both.theirs, u), i) << both.ours.nside();
}

TEST(HealpixLibrary, EntriesAreThePixelsOfTheLibrary) {
  for (std::size_t nside = 1; nside <= 64; ++nside) {
    const Both both(nside);
    ASSERT_EQ(both.ours.size(), static_cast<std::size_t>(both.theirs.Npix()));
    for (std::size_t i = 0; i < both.ours.size(); ++i) expect_same_entry(both, i);
  }
}

TEST(HealpixLibrary, EntriesOfFineGridsAreThePixelsOfTheLibrary) {
  for (const std::size_t nside : kLarge) {
    const Both both(nside);
    const std::size_t size = both.ours.size();
    ASSERT_EQ(size, static_cast<std::size_t>(both.theirs.Npix()));
    for (std::size_t i = 0; i < 1000; ++i) {
      expect_same_entry(both, i);
      expect_same_entry(both, size - 1 - i);
      expect_same_entry(both, size / 1000 * i + i % 7);
    }
  }
}

// Rounding of an angle, over the distance of two rings; near the poles that of cos(theta), too, over its
// difference between the first rings, 1 / (3 nside^2).
TEST(HealpixLibrary, WeightsAreThoseOfTheLibrary) {
  std::vector<Vec3> directions = test::random_directions(20000, 110);
  for (const Vec3& x : test::special_directions()) directions.push_back(x.normalized());
  for (double phi = 1e-9; phi < 0.5; phi *= 1.1) {
    directions.push_back(to_direction({phi, 1e5 * phi}));
    directions.push_back(-directions.back());
  }
  for (const std::size_t nside : {1U, 2U, 3U, 7U, 16U, 60U, 100U, 333U, 1024U}) {
    const Both both(nside);
    const auto n = static_cast<double>(nside);
    for (const Vec3& u : directions) {
      const double tolerance = 1e-15 * (4.0 + 4.0 * n + (u.z() * u.z() > 4.0 / 9.0 ? 3.0 * n * n : 0.0));
      ASSERT_LT(largest_difference(weights(both.ours, u), weights(both.theirs, u)), tolerance)
          << nside << " at " << u.transpose();
    }
  }
}

}  // namespace
}  // namespace impinge

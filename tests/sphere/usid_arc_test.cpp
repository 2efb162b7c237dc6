// SPDX-License-Identifier: GPL-3.0-or-later
// The helix with entries at equal true arc length, and the thesis' look-up among them.
#include "sphere/schemes/usid_arc.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sphere/elliptic.hpp"
#include "sphere/schemes/usid.hpp"

namespace impinge {
namespace {

TEST(UsidArc, SizesAndTurnsAreThoseOfUsid) {
  for (const double precision : {1.0, 0.5, 0.1, 0.05}) {
    const Usid usid = Usid::with_precision(precision);
    const UsidArc arc = UsidArc::with_precision(precision);
    EXPECT_EQ(arc.size(), usid.size());
    EXPECT_EQ(arc.helix_turns(), usid.helix_turns());
    EXPECT_EQ(arc.equator_points(), usid.equator_points());
  }
  EXPECT_THROW(UsidArc::with_turns(1), std::invalid_argument);
  EXPECT_THROW(UsidArc::with_turns(10'000'000), std::invalid_argument);
}

// theta = 2 k phi, with phi found by halving E(phi), which grows from each to the next by as much.
TEST(UsidArc, EntriesStandOnTheHelix) {
  for (const std::size_t turns : {2U, 229U, 4584U}) {
    const UsidArc helix = UsidArc::with_turns(turns);
    const double slope = 2.0 * static_cast<double>(turns);
    const double half = elliptic_e(0.5 * kPi, 1.0 + slope * slope);
    for (std::size_t i = 0; i < helix.size(); i += 1 + helix.size() / 300) {
      const double length = 2.0 * half * static_cast<double>(i) / static_cast<double>(helix.size() - 1);
      const bool south = length > half;
      double low = 0.0;
      double high = 0.5 * kPi;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (elliptic_e(middle, 1.0 + slope * slope) < (south ? 2.0 * half - length : length) ? low : high) =
            middle;
      }
      const Vec3 expected = to_direction({high, std::remainder(slope * high, 2.0 * kPi)});
      const Vec3 u = helix.direction(i);
      ASSERT_LT((Vec3(u.x(), south ? -u.y() : u.y(), south ? -u.z() : u.z()) - expected).norm(),
                1e-14 + 2e-15 * slope);
    }
  }
}

}  // namespace
}  // namespace impinge

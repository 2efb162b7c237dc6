// SPDX-License-Identifier: GPL-3.0-or-later
// P_a, P_b and P_0 ... P_3 of Figure 48 against the scheme's stencil and against the curve itself.
#include "curves/helix_neighbours.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "curves/helix_length.hpp"
#include "sphere/schemes/usid.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

// theta = 2 k phi modulo a turn, above and below, one turn apart.
TEST(HelixNeighbours, CrossingsAreOnTheCurveAndHoldTheVertex) {
  const HelixEntries entries = thesis_entries(10);
  for (const Vec3& u : test::random_directions(2000, 1)) {
    const auto found = helix_neighbours(entries, u);
    if (!found) continue;
    const auto [phi, theta] = to_angles(u);
    EXPECT_LE(found->phi_above, phi + 1e-12);
    EXPECT_GE(found->phi_below, phi - 1e-12);
    EXPECT_NEAR(found->phi_below - found->phi_above, kPi / 10.0, 1e-14);
    for (const double crossing : {found->phi_above, found->phi_below}) {
      EXPECT_NEAR(std::remainder(20.0 * crossing - theta, 2.0 * kPi), 0.0, 1e-12);
    }
  }
}

TEST(HelixNeighbours, AreTheTapsOfUsid) {
  for (const std::size_t turns : {3UL, 10UL, 229UL}) {
    const Usid usid = Usid::with_turns(turns);
    for (const Vec3& u : test::random_directions(2000, 2)) {
      const auto found = helix_neighbours(thesis_entries(turns), u);
      const Stencil stencil = usid.stencil(u);
      ASSERT_EQ(found.has_value(), stencil.taps == 4);
      if (found) {
        ASSERT_EQ(found->entry, stencil.entry);
      }
    }
  }
}

TEST(HelixNeighbours, TheirTravelIsBetweenTheirEntries) {
  const HelixEntries entries = thesis_entries(10);
  const double spacing = total_travelled_distance(10.0) / 99.0;
  for (const Vec3& u : test::random_directions(2000, 3)) {
    const auto found = helix_neighbours(entries, u);
    if (!found) continue;
    EXPECT_NEAR(found->travelled_above / spacing - static_cast<double>(found->entry[0]), 0.5, 0.5);
    EXPECT_NEAR(found->travelled_below / spacing - static_cast<double>(found->entry[2]), 0.5, 0.5);
  }
}

TEST(HelixNeighbours, NoneAtThePolesAndRefusesNoHelix) {
  EXPECT_FALSE(helix_neighbours(thesis_entries(10), {0.001, 0.001, 1}));
  EXPECT_FALSE(helix_neighbours(thesis_entries(10), {0, 0.01, -1}));
  EXPECT_THROW(helix_neighbours({1.0, 100}, {1, 0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// The plain look-up against the scheme's, and against entries at equal arc.
#include "curves/helix_stencil.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "curves/helix_length.hpp"
#include "sphere/schemes/usid.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

constexpr HelixIndex kAll[] = {HelixIndex::true_arc, HelixIndex::eq10_true_spacing,
                               HelixIndex::eq10_own_spacing};

TEST(HelixStencil, ByEq10sOwnSpacingIsUsids) {
  for (const std::size_t turns : {3UL, 10UL, 229UL}) {
    const Usid usid = Usid::with_turns(turns);
    for (const Vec3& u : test::random_directions(2000, 1)) {
      const Stencil found = helix_stencil(thesis_entries(turns), HelixIndex::eq10_own_spacing, u);
      const Stencil expected = usid.stencil(u);
      ASSERT_EQ(found.taps, expected.taps);
      for (std::size_t k = 0; k < found.taps; ++k) {
        ASSERT_EQ(found.entry[k], expected.entry[k]) << turns;
        ASSERT_NEAR(found.weight[k], expected.weight[k], 1e-9);
      }
    }
  }
}

// place(phi_i) = i for entries at equal arc.
TEST(HelixStencil, ByTrueArcFindsTheEntriesAtEqualArc) {
  for (const std::size_t turns : {3UL, 10UL, 229UL}) {
    const HelixEntries entries = thesis_entries(turns);
    for (std::size_t i = 0; i < entries.count; i += 1 + entries.count / 500) {
      const double phi = polar_angle_of_equal_arc(entries, i);
      EXPECT_NEAR(helix_place(entries, HelixIndex::true_arc, phi), static_cast<double>(i), 1e-8);
      const Stencil stencil =
          helix_stencil(entries, HelixIndex::true_arc, to_direction({phi, 2.0 * entries.turns * phi}));
      double at_entry = 0.0;
      for (std::size_t k = 0; k < stencil.taps; ++k) {
        if (stencil.entry[k] == i) at_entry += stencil.weight[k];
      }
      EXPECT_NEAR(at_entry, 1.0, 1e-8) << i;
    }
  }
}

TEST(HelixStencil, WeightsSumToOneAndEntriesExist) {
  auto directions = test::random_directions(5000, 2);
  for (const Vec3& x : test::special_directions()) directions.push_back(x.normalized());
  for (const HelixIndex index : kAll) {
    const HelixEntries entries = thesis_entries(12);
    for (const Vec3& u : directions) {
      const Stencil stencil = helix_stencil(entries, index, u);
      double sum = 0.0;
      for (std::size_t k = 0; k < stencil.taps; ++k) {
        ASSERT_LT(stencil.entry[k], entries.count);
        ASSERT_GE(stencil.weight[k], 0.0);
        sum += stencil.weight[k];
      }
      ASSERT_NEAR(sum, 1.0, 1e-14);
    }
  }
}

// The place by Eq. 10 is off by what index_mismatch() says, until it is cut at the end of the table.
TEST(HelixPlace, IsOffByTheMismatch) {
  const HelixEntries entries = thesis_entries(229);
  for (const double phi : {0.1, 1.0, 2.0, 2.8}) {
    const double place = helix_place(entries, HelixIndex::true_arc, phi);
    EXPECT_NEAR(helix_place(entries, HelixIndex::eq10_own_spacing, phi) - place,
                index_mismatch(entries, HelixSpacing::travelled, phi), 1e-9);
    EXPECT_NEAR(helix_place(entries, HelixIndex::eq10_true_spacing, phi) - place,
                index_mismatch(entries, HelixSpacing::true_arc, phi), 1e-9);
  }
  for (const HelixIndex index : kAll) EXPECT_EQ(helix_place(entries, index, kPi), 52440.0);
  EXPECT_THROW(helix_place({10.0, 1}, HelixIndex::true_arc, 1.0), std::invalid_argument);
  EXPECT_THROW(helix_stencil({1.0, 100}, HelixIndex::true_arc, {1, 0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace impinge

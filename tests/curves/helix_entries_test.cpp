// SPDX-License-Identifier: GPL-3.0-or-later
// Entries at equal T (Eq. 10) and at equal arc length; the index that Eq. 10 gives for the latter.
#include "curves/helix_entries.hpp"

#include <cmath>
#include <cstdint>
#include <stdexcept>

#include <gtest/gtest.h>

#include "curves/helix_length.hpp"
#include "sphere/direction.hpp"
#include "sphere/schemes/usid.hpp"

namespace impinge {
namespace {

// cos(phi_i) = 1 - 2 i / (w - 1), the entries of the scheme.
TEST(HelixEntries, AtEqualTravelAreThoseOfUsid) {
  for (const std::size_t turns : {2UL, 10UL, 229UL, 100000UL}) {
    const HelixEntries entries = thesis_entries(turns);
    const Usid usid = Usid::with_turns(turns);
    ASSERT_EQ(entries.count, usid.size());
    for (std::size_t i = 0; i < entries.count; i += 1 + entries.count / 1000) {
      ASSERT_NEAR(polar_angle_of_equal_travel(entries, i), to_angles(usid.direction(i)).phi, 1e-14);
    }
    EXPECT_EQ(polar_angle_of_equal_travel(entries, 0), 0.0);
    EXPECT_EQ(polar_angle_of_equal_travel(entries, entries.count - 1), kPi);
  }
}

// By definition: index of Eq. 10 at an entry that stands at place i, minus i.
TEST(IndexMismatch, IsTheIndexOfEq10MinusTheEntry) {
  const HelixEntries entries = thesis_entries(229);
  const double dx = helix_total_length(229.0) / 52440.0;
  for (const std::size_t i : {0UL, 1UL, 77UL, 1000UL, 26220UL, 50000UL, 52440UL}) {
    const double phi = polar_angle_of_equal_arc(entries, i);
    const double t = travelled_distance(229.0, phi);
    EXPECT_NEAR(index_mismatch(entries, HelixSpacing::true_arc, phi), t / dx - static_cast<double>(i), 1e-8);
    EXPECT_NEAR(index_mismatch(entries, HelixSpacing::travelled, phi),
                t / (917.0 / 52440.0) - static_cast<double>(i), 1e-8);
  }
}

// Against the largest over many places.
TEST(IndexMismatch, LargestIsWhereItIsSaidToBe) {
  for (const std::size_t turns : {2UL, 10UL, 229UL, 4584UL}) {
    const HelixEntries entries = thesis_entries(turns);
    for (const HelixSpacing spacing : {HelixSpacing::true_arc, HelixSpacing::travelled}) {
      const Mismatch largest = largest_index_mismatch(entries, spacing);
      EXPECT_DOUBLE_EQ(index_mismatch(entries, spacing, largest.phi), largest.index);
      double found = 0.0;
      for (int i = 0; i <= 20000; ++i) {
        const double phi = 0.5 * kPi * (1.0 - std::cos(kPi * i / 20000.0));
        found = std::max(found, std::abs(index_mismatch(entries, spacing, phi)));
      }
      EXPECT_LE(found, std::abs(largest.index) * (1.0 + 1e-9)) << turns;
      EXPECT_GE(found, std::abs(largest.index) * (1.0 - 1e-5)) << turns;
    }
  }
}

TEST(HelixEntries, RefusesWhatIsNone) {
  EXPECT_THROW(polar_angle_of_equal_arc(thesis_entries(1), 0), std::invalid_argument);
  EXPECT_THROW(polar_angle_of_equal_travel(thesis_entries(0), 0), std::invalid_argument);
  EXPECT_THROW(polar_angle_of_equal_arc({10.0, 0}, 0), std::invalid_argument);
  EXPECT_THROW(polar_angle_of_equal_arc({10.0, 1}, 0), std::invalid_argument);
  EXPECT_THROW(polar_angle_of_equal_travel({10.0, 100}, 100), std::invalid_argument);
  EXPECT_THROW(largest_index_mismatch({1.5, 100}, HelixSpacing::travelled), std::invalid_argument);
  const HelixEntries huge = thesis_entries(100000);
  const double phi = polar_angle_of_equal_arc(huge, huge.count / 3);
  EXPECT_NEAR(helix_length(1e5, phi) / helix_total_length(1e5) * static_cast<double>(huge.count - 1),
              static_cast<double>(huge.count / 3), 1e-3);
}

}  // namespace
}  // namespace impinge

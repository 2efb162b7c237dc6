// SPDX-License-Identifier: GPL-3.0-or-later
// L(phi) = integral_0^phi sqrt(1 + 4 k^2 sin^2 t) dt against quadrature, chords and its asymptote; T of
// Eq. 10.
#include "curves/helix_length.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "curves/gsl.hpp"
#include "curves/helix_length.hpp"
#include "sphere/direction.hpp"
#include "sphere/scheme.hpp"
#include "sphere/schemes/usid.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

constexpr double kTurns[] = {2.0, 2.5, 10.0, 229.0, 458.0, 2292.0, 4584.0, 1e5};

double quadrature(double k, double from, double to) {
  return integrate([k](double t) { return std::hypot(1.0, 2.0 * k * std::sin(t)); }, from, to);
}

// In pieces that shrink towards both poles, where the speed falls to 1 within an angle of 1 / k.
TEST(HelixLength, IsTheIntegralOfTheSpeed) {
  for (const double k : kTurns) {
    double expected = 0.0;
    double from = 0.0;
    for (const double phi : {1e-8, 1e-5, 1e-3, 0.1, 1.0, 0.5 * kPi, 1.6, 3.0, 3.14, kPi - 1e-5, kPi}) {
      expected += quadrature(k, from, phi);
      from = phi;
      EXPECT_NEAR(helix_length(k, phi), expected, 1e-13 * expected) << k << ' ' << phi;
    }
  }
}

// The length of the polygon through many points of the curve approaches that of the curve from below.
TEST(HelixLength, IsTheLengthOfTheCurve) {
  const auto point = [](double phi) { return to_direction({phi, 2.0 * 10.0 * phi}); };
  const int parts = 200000;
  double length = 0.0;
  for (int i = 0; i < parts; ++i) length += (point(kPi * (i + 1) / parts) - point(kPi * i / parts)).norm();
  EXPECT_NEAR(helix_total_length(10.0), length, 1e-6);
  EXPECT_GT(helix_total_length(10.0), length);
}

TEST(HelixLength, TotalIsNot4kPlus1) {
  EXPECT_NEAR(helix_total_length(229.0), 916.0175, 5e-5);
  EXPECT_EQ(total_travelled_distance(229.0), 917.0);
}

TEST(HelixLength, ApproachesItsAsymptote) {
  for (const double k : kTurns) {
    const double rest = helix_total_length(k) - helix_total_length_asymptote(k);
    const double rounding = 1e-15 * 4.0 * k;
    EXPECT_LT(std::abs(rest), (1.0 + std::log(8.0 * k)) / (32.0 * k * k * k) + rounding) << k;
  }
}

TEST(HelixLength, NorthMirrorsSouth) {
  for (const double k : kTurns) {
    for (const double phi : {0.0, 1e-6, 0.3, 1.2, 0.5 * kPi}) {
      EXPECT_NEAR(helix_length(k, phi) + helix_length(k, kPi - phi), helix_total_length(k), 4e-15 * 4.0 * k);
    }
  }
}

TEST(HelixLength, InverseRoundTripsAtBothPolesToo) {
  for (const double k : kTurns) {
    const double total = helix_total_length(k);
    for (const double share : {0.0, 1e-14, 1e-9, 0.001, 0.3, 0.5, 0.7, 1.0 - 1e-9, 1.0}) {
      const double phi = polar_angle_at_length(k, share * total);
      EXPECT_NEAR(helix_length(k, phi), share * total, 1e-13 * total * std::min(share + 1e-3, 1.0)) << k;
    }
    for (const double phi : {1e-12, 1e-6, 0.2, 1.5, 1.7}) {
      EXPECT_NEAR(polar_angle_at_length(k, helix_length(k, phi)), phi, 2e-13 * phi) << k;
    }
    EXPECT_EQ(polar_angle_at_length(k, 0.0), 0.0);
    EXPECT_EQ(polar_angle_at_length(k, total), kPi);
    EXPECT_EQ(polar_angle_at_length(k, total * (1.0 + 1e-15)), kPi);
  }
}

// T = (4 k + 1) (1 - cos phi) / 2.
TEST(TravelledDistance, IsEq10AndHasAnInverse) {
  for (const double k : kTurns) {
    for (const double phi : {0.0, 0.3, 1.2, 0.5 * kPi, 2.0, kPi}) {
      const double t = travelled_distance(k, phi);
      EXPECT_NEAR(t, (4.0 * k + 1.0) * (1.0 - std::cos(phi)) / 2.0, 1e-15 * (4.0 * k + 1.0));
      EXPECT_NEAR(polar_angle_at_travelled_distance(k, t), phi, 1e-14);
    }
    EXPECT_EQ(travelled_distance(k, kPi), total_travelled_distance(k));
  }
}

TEST(HelixLength, RefusesWhatIsNoHelixAndNoPlaceOnIt) {
  for (const double k : {1.999, 0.0, -5.0, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(helix_length(k, 1.0), std::invalid_argument);
    EXPECT_THROW(helix_total_length(k), std::invalid_argument);
    EXPECT_THROW(helix_total_length_asymptote(k), std::invalid_argument);
    EXPECT_THROW(travelled_distance(k, 1.0), std::invalid_argument);
    EXPECT_THROW(polar_angle_at_length(k, 1.0), std::invalid_argument);
    EXPECT_THROW(polar_angle_at_travelled_distance(k, 1.0), std::invalid_argument);
  }
  for (const double phi : {-1e-9, 3.2, std::nan("")}) {
    EXPECT_THROW(helix_length(10.0, phi), std::invalid_argument);
    EXPECT_THROW(travelled_distance(10.0, phi), std::invalid_argument);
  }
  for (const double length : {-0.1, 41.1, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(polar_angle_at_length(10.0, length), std::invalid_argument);
    EXPECT_THROW(polar_angle_at_travelled_distance(10.0, length), std::invalid_argument);
  }
}

// Entries at equal T (Eq. 10) and at equal arc length; the index that Eq. 10 gives for the latter.

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

// P_a, P_b and P_0 ... P_3 of Figure 48 against the scheme's stencil and against the curve itself.

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

// The plain look-up against the scheme's, and against entries at equal arc.

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

// Interpolated minus true radius, by hand.

TEST(LookupError, IsThatOfTwoKnownDirections) {
  const std::vector<double> radii{10.0, 14.0};
  const auto stencil = [](const Vec3& u) {
    return u.z() > 0.0 ? Stencil{{0, 1, 0, 0}, {0.75, 0.25, 0.0, 0.0}, 2, 0}
                       : Stencil{{1, 0, 0, 0}, {1.0}, 1, 0};
  };
  const std::vector<Vec3> directions{{0, 0, 1}, {0, 0, -1}};
  const LookupError error = lookup_error(
      radii, stencil, [](const Vec3&) { return 10.0; }, directions);
  EXPECT_DOUBLE_EQ(error.largest, 4.0);
  EXPECT_DOUBLE_EQ(error.root_mean_square, std::sqrt((1.0 + 16.0) / 2.0));
}

}  // namespace
}  // namespace impinge

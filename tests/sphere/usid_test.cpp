// SPDX-License-Identifier: GPL-3.0-or-later
// USID: theta = 2 k phi, w = k^2, cos(phi_i) = 1 - 2 i / (w - 1) (thesis, Eq. 9-10, Tables 6-7).
#include "sphere/schemes/usid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sphere/elliptic.hpp"
#include "sphere/height_steps.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/schemes/usid_arc.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

TEST(Usid, TurnsAndSizesAreThoseOfTables6And7) {
  constexpr std::array precision{1.0, 0.5, 0.1, 0.05};
  constexpr std::array<std::size_t, 4> turns{229, 458, 2292, 4584};
  constexpr std::array<std::size_t, 4> entries{52441, 209764, 5253264, 21013056};
  constexpr std::array<std::size_t, 4> equator{360, 720, 3601, 7201};
  for (std::size_t k = 0; k < 4; ++k) {
    const Usid helix = Usid::with_precision(precision[k]);
    EXPECT_EQ(helix.helix_turns(), turns[k]);
    EXPECT_EQ(helix.size(), entries[k]);
    EXPECT_EQ(helix.equator_points(), equator[k]);
    EXPECT_EQ(RadialTable<Usid>::bytes(helix), entries[k] * 8);
    EXPECT_NEAR(helix.precision_deg(), precision[k], 2e-3 * precision[k]);
  }
}

TEST(Usid, ThreeTapsOnTheFirstAndLastTurnFourBetween) {
  const Usid helix = Usid::with_turns(40);
  const double turn = kPi / 40.0;
  for (double theta = 0.05; theta < 2.0 * kPi; theta += 0.1) {
    const double first = theta / 80.0;              // the first turn is at theta / 2 k
    const double last = kPi - turn + theta / 80.0;  // and the last one ends in the other pole
    EXPECT_EQ(helix.stencil(to_direction({0.5 * first, theta})).taps, 3U);
    EXPECT_EQ(helix.stencil(to_direction({first + 0.01 * turn, theta})).taps, 4U);
    EXPECT_EQ(helix.stencil(to_direction({last - 0.01 * turn, theta})).taps, 4U);
    EXPECT_EQ(helix.stencil(to_direction({0.5 * (last + kPi), theta})).taps, 3U);
  }
}

// Between P_a and P_b the value is linear in phi, along a turn it is linear in the index: r = index is met.
TEST(Usid, InterpolatesBetweenTheTurns) {
  const Usid helix = Usid::with_precision(2.0);
  RadialTable<Usid> table(helix);
  for (std::size_t i = 0; i < helix.size(); ++i) table.radii()[i] = 1.0 + static_cast<double>(i);
  const double turn = kPi / static_cast<double>(helix.helix_turns());
  for (const Vec3& u : test::random_directions(5000, 50)) {
    const auto [phi, theta] = to_angles(u);
    const double phi_a =
        theta / (2.0 * static_cast<double>(helix.helix_turns())) +
        turn * std::floor((phi - theta / (2.0 * static_cast<double>(helix.helix_turns()))) / turn);
    if (phi_a < 0.0 || phi_a + turn > kPi) continue;
    const double share = (phi - phi_a) / turn;
    const double expected = 1.0 + (1.0 - share) * helix.place(phi_a) + share * helix.place(phi_a + turn);
    ASSERT_NEAR(table.radius_at(u), expected, 1e-8);
  }
}

// A way from u to a tap, along the strip between two turns, meets only cells that for_each_cell_across()
// names.
TEST(Usid, CellsAcrossHoldTheWaysToTheTaps) {
  const Usid helix = Usid::with_turns(9);
  const double slope = 2.0 * 9.0;
  for (const Vec3& u : test::random_directions(20000, 55)) {
    const Stencil stencil = helix.stencil(u);
    if (stencil.taps == 3) continue;
    std::set<std::size_t> across;
    helix.for_each_cell_across(stencil, [&](const Stencil& other) { across.insert(other.cell); });
    ASSERT_TRUE(across.contains(stencil.cell));
    const auto [phi, theta] = to_angles(u);
    const double turn = std::floor((slope * phi - theta) / (2.0 * kPi));
    const double along =
        slope * phi - 2.0 * kPi * turn - theta;  // 0 on the turn above, 2 pi on the one below
    for (std::size_t k = 0; k < 4; ++k) {
      const double phi_tap = to_angles(helix.direction(stencil.entry[k])).phi - (k < 2 ? 0.0 : kPi / 9.0);
      const double end = k < 2 ? 1e-6 : 2.0 * kPi - 1e-6;
      for (double t = 0.0; t < 0.999; t += 0.04) {
        const double azimuth = theta + t * (slope * phi_tap - 2.0 * kPi * turn - theta);
        const double offset = along + t * (end - along);
        const Vec3 v = to_direction({(azimuth + offset + 2.0 * kPi * turn) / slope, azimuth});
        ASSERT_TRUE(across.contains(helix.stencil(v).cell)) << u.transpose() << " tap " << k;
      }
    }
  }
}

TEST(Usid, RefusesFewerThanTwoTurns) {
  EXPECT_THROW(Usid::with_turns(0), std::invalid_argument);
  EXPECT_THROW(Usid::with_turns(1), std::invalid_argument);
  EXPECT_THROW(Usid::with_turns(1'000'000'000), std::invalid_argument);
  EXPECT_EQ(Usid::with_turns(100'000).size(), 10'000'000'000U);
}

// The helix with entries at equal true arc length, and the thesis' look-up among them.

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

// Entries of a helix at equal steps of height, one by one and in runs.

// Against long double. What is left is the rounding of sqrt(i / (w - 1)) and of a quotient, at most 3/4 of
// 2^-53 of theta, which is pi k at the equator, and a little.
TEST(HeightSteps, EntriesStandOnTheHelixForAnySlope) {
  std::mt19937_64 random(72);
  for (const std::size_t size : {std::size_t{4}, std::size_t{100}, std::size_t{52441}, std::size_t{21013056},
                                 std::size_t{10'000'000'000}}) {
    const double root = std::sqrt(static_cast<double>(size));
    for (const double slope : {2.0 * std::round(root), std::sqrt(kPi) * root}) {
      const HeightSteps steps(size, slope);
      double largest = 0.0;
      for (int k = 0; k < 20000; ++k) {
        const std::size_t i = random() % size;
        const long double share = static_cast<long double>(i) / static_cast<long double>(size - 1);
        const long double phi = 2.0L * std::atan2(std::sqrt(share), std::sqrt(1.0L - share));
        const long double theta = static_cast<long double>(slope) * phi;
        const Vec3 expected(static_cast<double>(std::sin(phi) * std::cos(theta)),
                            static_cast<double>(std::sin(phi) * std::sin(theta)),
                            static_cast<double>(1.0L - 2.0L * share));
        largest = std::max(largest, (steps.direction(i) - expected).norm());
      }
      EXPECT_LT(largest, 6e-16 + 1.5e-16 * kPi * slope) << size << ' ' << slope;
    }
  }
}

// The numbers of a run are those of direction(), wherever it starts and however long it is.
TEST(HeightSteps, RunsHoldTheVeryNumbersOfDirection) {
  constexpr std::size_t kSize = 100003;
  const HeightSteps steps(kSize, 777.7);
  DirectionRun run;
  for (run.count = 1; run.count <= DirectionRun::kMost; ++run.count) {
    for (const std::size_t first : {std::size_t{0}, 49980 + run.count, kSize - run.count}) {
      run.first = first;
      steps.fill(run);
      for (std::size_t k = 0; k < run.count; ++k) ASSERT_EQ(run[k], steps.direction(first + k));
    }
  }
}

TEST(HeightSteps, PlaceAndPolarAngleAreInverse) {
  const HeightSteps steps(1000001, 2000.0);
  for (double t = 0.0; t <= 1e6; t += 97.3) {
    EXPECT_NEAR(steps.place(steps.polar_angle(t)), t, 1e-15 * (t < 5e5 ? 3.0 * t + 1.0 : 1e6));
    EXPECT_NEAR(steps.turn(steps.polar_of_turn(t / 1001.0)), t / 1001.0, 1e-12);
  }
}

}  // namespace
}  // namespace impinge

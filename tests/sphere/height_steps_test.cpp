// SPDX-License-Identifier: GPL-3.0-or-later
// Entries of a helix at equal steps of height, one by one and in runs.
#include "sphere/height_steps.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace impinge {
namespace {

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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "spectrum/power_spectrum.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace impinge {
namespace {

const std::vector<double> kPower{1000.0, 80.0, 15.0, 4.0, 1.0};

TEST(PowerSpectrum, SharesLeaveOutTheMean) {
  const auto shares = cumulative_shares(kPower);
  const std::vector<double> expected{0.0, 0.8, 0.95, 0.99, 1.0};
  for (std::size_t l = 0; l < expected.size(); ++l) EXPECT_NEAR(shares[l], expected[l], 1e-15);
}

TEST(PowerSpectrum, BandLimitIsTheSmallestThatDoes) {
  EXPECT_EQ(band_limit(kPower, 0.0), 1U);
  EXPECT_EQ(band_limit(kPower, 0.8), 2U);
  EXPECT_EQ(band_limit(kPower, 0.81), 3U);
  EXPECT_EQ(band_limit(kPower, 0.98), 4U);
  EXPECT_EQ(band_limit(kPower, 1.0), 5U);
  EXPECT_EQ(band_limit({5.0, 0.0, 0.0}, 0.99), 1U);  // a sphere about the centre
}

TEST(PowerSpectrum, RestIsWhatTheBandLimitLeavesOut) {
  EXPECT_DOUBLE_EQ(rms_beyond(kPower, 3), std::sqrt(5.0 / (4.0 * kPi)));
  EXPECT_EQ(rms_beyond(kPower, 5), 0.0);
  for (const double rms : {0.1, 0.3, 0.7, 2.0, 100.0}) {
    const std::size_t limit = band_limit_leaving(kPower, rms);
    EXPECT_LE(limit == 5 ? 0.0 : rms_beyond(kPower, limit), rms);
    if (limit > 1) {
      EXPECT_GT(rms_beyond(kPower, limit - 1), rms);
    }
  }
}

// Entries and coefficients of the papers' own examples: L = 1 is a constant, which one entry determines.
TEST(SamplingTheorems, CountEntries) {
  EXPECT_EQ(optimal_entries(55), 3025U);
  EXPECT_EQ(mcewen_wiaux_entries(55), 5887U);
  EXPECT_EQ(driscoll_healy_entries(55), 12100U);
  EXPECT_EQ(mcewen_wiaux_entries(1), 1U);
  for (const std::size_t limit : {2U, 10U, 1000U}) {
    EXPECT_LE(optimal_entries(limit), mcewen_wiaux_entries(limit));
    EXPECT_LT(mcewen_wiaux_entries(limit), driscoll_healy_entries(limit));
    EXPECT_LE(mcewen_wiaux_entries(limit), 2 * limit * limit);
  }
  EXPECT_DOUBLE_EQ(nyquist_angle_deg(180), 1.0);
}

TEST(SamplingTheorems, AGapDeterminesABandLimit) {
  EXPECT_EQ(band_limit_of_gap(2.0 * kPi), 1U);         // one entry: the constant
  EXPECT_EQ(band_limit_of_gap(2.0 * kPi / 11.0), 6U);  // 11 entries: degree 5
  EXPECT_EQ(band_limit_of_gap(2.0 * kPi / 10.9), 5U);
  EXPECT_EQ(band_limit_of_gap(kDegree), 180U);
  EXPECT_THROW(band_limit_of_gap(0.0), std::invalid_argument);
  EXPECT_THROW(band_limit_of_gap(std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace impinge

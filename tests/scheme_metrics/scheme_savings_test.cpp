// SPDX-License-Identifier: GPL-3.0-or-later
// What the thesis calls 20 % less memory, in its meanings; and that a saving is that of a real table: as good
// as the reference, while the next smaller one is not.
#include "scheme_metrics/scheme_savings.hpp"

#include <gtest/gtest.h>

#include "sphere/schemes/rsid.hpp"
#include "sphere/schemes/usid.hpp"
#include "sphere/uniform_directions.hpp"
#include "support/every_scheme.hpp"

namespace impinge {
namespace {

// 1 - (2 (360 / p) / pi)^2 / ((180 / p + 1) (360 / p)) -> 1 - 8 / pi^2 = 18.9 %
TEST(SchemeSavings, HelixAtEqualSpacingIsTheClosedForm) {
  EXPECT_NEAR(saved_percent(saving_at_equal_spacing<Usid>(1.0)->entries, Rsid::with_precision(1.0).size()),
              19.52, 0.005);
  const auto fine = saving_at_equal_spacing<Usid>(0.005);
  EXPECT_NEAR(saved_percent(fine->entries, Rsid::with_precision(0.005).size()),
              100.0 * (1.0 - 8.0 / (kPi * kPi)), 0.01);
}

TEST(SchemeSavings, ReferenceSavesNothing) {
  const ErrorProbe probe(BandLimited({10.0, 8, 16, 1}), uniform_directions(5000, 2));
  const Rsid rsid = Rsid::with_precision(5.0);
  EXPECT_EQ(saving_at_equal_gap(rsid, measured_covering_radius(rsid))->entries, rsid.size());
  for (const Saving& saving : savings_at_equal_error(rsid, interpolation_error(rsid, probe), probe)) {
    EXPECT_EQ(saving.entries, rsid.size()) << saving.meaning;
    EXPECT_EQ(saving.measured_ratio, 1.0) << saving.meaning;
  }
}

TEST(SchemeSavings, EqualGapsAreThoseOfTheSmallestTable) {
  const Rsid rsid = Rsid::with_precision(6.0);
  const double radius = measured_covering_radius(rsid);
  test::every_scheme([&]<class S>() {
    const auto saving = saving_at_equal_gap(scheme_of_size<S>(rsid.size()), radius);
    ASSERT_TRUE(saving) << S::name;
    SizeLevels<S> levels(saving->entries);
    const auto table = levels.first_of(saving->entries);
    ASSERT_EQ(table->size(), saving->entries) << S::name;
    EXPECT_EQ(measured_covering_radius(*table), saving->measured_ratio * radius) << S::name;
    EXPECT_LE(saving->measured_ratio, 1.0) << S::name;
    const auto smaller = levels.smaller(saving->entries);
    ASSERT_TRUE(smaller) << S::name;
    EXPECT_GT(measured_covering_radius(*smaller), radius) << S::name;
  });
}

TEST(SchemeSavings, EqualErrorsAreEqualAsFarAsSizesGo) {
  const ErrorProbe probe(BandLimited({10.0, 8, 64, 1}), uniform_directions(20000, 2));
  const InterpolationError target = interpolation_error(Rsid::with_precision(3.0), probe);
  test::every_scheme([&]<class S>() {
    const auto savings = savings_at_equal_error(scheme_of_size<S>(7320), target, probe);
    ASSERT_EQ(savings.size(), 2U) << S::name;
    // A grid of 12 n^2 entries comes in steps of 8 % here; the largest errors scatter.
    EXPECT_NEAR(savings[0].measured_ratio, 1.0, 0.2) << S::name;
    EXPECT_NEAR(savings[1].measured_ratio, 1.0, 0.1) << S::name;
  });
}

}  // namespace
}  // namespace impinge

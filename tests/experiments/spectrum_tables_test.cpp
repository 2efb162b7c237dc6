// SPDX-License-Identifier: GPL-3.0-or-later
#include "05_slices/spectrum_tables.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace impinge::lab {
namespace {

TEST(BandLimitTable, HoldsWhatEachTheoremAsks) {
  BandLimitTable limits = band_limit_table({{"name", "", ""}}, "a grid", 65160);
  add_band_limit(limits, {"slices"}, 55);
  EXPECT_EQ(to_csv(limits.table),
            "name,band_limit,optimal,mcewen_wiaux,driscoll_healy,reference_entries,oversampling,nyquist_deg\n"
            "slices,55,3025,5887,12100,65160,11.06845591982334,3.272727272727273\n");
}

// Y_10 with an amplitude of 1 mm about a mean radius: all power at degree 1.
TEST(SpectrumTables, ASurfaceWithHolesHasRowsForEachFilling) {
  const GaussGrid grid(16);
  NamedSurface closed{"closed", sample(grid, [](const Vec3& u) { return 20.0 + u.z(); })};
  NamedSurface open = closed;
  open.name = "open";
  for (std::size_t j = 0; j < grid.columns(); ++j) open.radii[j] = std::nan("");
  const SpectrumTables tables = spectrum_tables(grid, {closed, open}, "a grid", 100);
  ASSERT_EQ(tables.spectrum.rows.size(), 3U * 16U);
  EXPECT_EQ(tables.spectrum.rows[0][1].text(), "none");
  EXPECT_EQ(tables.spectrum.rows[16][1].text(), "membrane");
  EXPECT_EQ(tables.spectrum.rows[32][1].text(), "plate");
  EXPECT_NEAR(std::stod(tables.spectrum.rows[0][3].text()), 4.0 * kPi * 400.0, 1e-9);
  EXPECT_NEAR(std::stod(tables.spectrum.rows[1][3].text()), 4.0 * kPi / 3.0, 1e-12);
  ASSERT_EQ(tables.limits.table.rows.size(), 3U * (kPowerShares.size() + kRests.size()));
  EXPECT_EQ(tables.limits.table.rows[0][2].text(), "1");
  EXPECT_EQ(tables.limits.table.rows[0][7].text(), "2");  // degrees 0 and 1
  EXPECT_LT(std::stod(tables.limits.table.rows.back()[2].text()), 1.0);
}

}  // namespace
}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// Entries and look-up that fit each other interpolate; those that do not read wrong entries.
#include "06_helix_placement/helix_lookup.hpp"

#include <array>
#include <map>
#include <string>

#include <gtest/gtest.h>

namespace impinge::lab {
namespace {

TEST(HelixLookupErrors, AreSmallWhereEntriesAndLookupFit) {
  constexpr std::array<std::size_t, 1> turns{90};
  const Result result = helix_lookup_errors(turns);
  ASSERT_EQ(result.table.rows.size(), 4U);
  std::map<std::string, double> rms;
  for (const auto& row : result.table.rows)
    rms[row[2].text() + ' ' + row[3].text()] = std::stod(row[5].text());
  EXPECT_LT(rms.at("equal_travel eq10"), 0.005);
  EXPECT_NEAR(rms.at("equal_arc true_arc"), rms.at("equal_travel eq10"), 0.02 * rms.at("equal_travel eq10"));
  EXPECT_GT(rms.at("equal_arc eq10_own_spacing"), 1.5 * rms.at("equal_arc true_arc"));
  EXPECT_GT(rms.at("equal_arc eq10_true_spacing"), 20.0 * rms.at("equal_arc true_arc"));
}

}  // namespace
}  // namespace impinge::lab

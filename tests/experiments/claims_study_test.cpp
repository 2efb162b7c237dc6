// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: each claim's rows are those of the small scene, and every time has its row.
#include "20_claims/claims_study.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

namespace impinge::lab {
namespace {

ClaimsOptions small_claims() {
  ClaimsOptions options;
  options.faces = 1000;
  options.precision_deg = 4.0;
  options.collision_precisions = {2.0};
  options.caps = {15.0, 60.0};
  options.rounds = 1;
  return options;
}

double claims_value(const ClaimsStudy& study, const std::string& setting, const std::string& quantity) {
  const auto row = std::ranges::find_if(
      study.rows, [&](const Claim& r) { return r.setting == setting && r.quantity == quantity; });
  if (row == study.rows.end()) return std::nan("");
  return row->value;
}

TEST(Claims, AWiderCapChangesMore) {
  ClaimsStudy study;
  add_deforming(study, small_claims());
  const double few = claims_value(study, "cap of 15 degrees", "entries worked out");
  const double many = claims_value(study, "cap of 60 degrees", "entries worked out");
  EXPECT_GT(few, 10.0);
  EXPECT_GT(many, 4.0 * few);
  EXPECT_LT(many, 90.0 * 46.0) << "not the whole table";
  EXPECT_GT(claims_value(study, "cap of 60 degrees", "faces changed"),
            claims_value(study, "cap of 15 degrees", "faces changed"));
  EXPECT_EQ(study.cases.size(), 4U);
}

TEST(Claims, ALargerToleranceFindsMoreCrossings) {
  ClaimsStudy study;
  add_self_collision(study, small_claims());
  EXPECT_GT(claims_value(study, "exact", "pairs crossing"), 10.0);
  const double tight = claims_value(study, "2 degrees, within 0.001 mm", "crossing pairs found");
  const double wide = claims_value(study, "2 degrees, within 0.1 mm", "crossing pairs found");
  EXPECT_LE(tight, wide);
  EXPECT_GT(wide, 10.0);
  EXPECT_LE(wide, 100.0);
  EXPECT_EQ(claims_value(study, "2 degrees, within 0.001 mm", "pairs found that do not cross"), 0.0);
}

TEST(Claims, AddingADistanceIsRightOnASphereAlone) {
  ClaimsStudy study;
  add_layers(study, small_claims());
  EXPECT_LT(claims_value(study, "normal hip, under the socket", "distance added, rms error"), 0.1);
  EXPECT_GT(claims_value(study, "normal hip, whole ball", "distance added, largest error"), 1.0)
      << "the neck is oblique";
}

TEST(Claims, EveryTimeHasItsRow) {
  ClaimsStudy study;
  add_deforming(study, small_claims());
  std::ostringstream told;
  Progress progress("test", &told);
  const ClaimsTables tables = claims_tables(study, progress);
  EXPECT_EQ(tables.table.rows.size(), study.rows.size() + study.cases.size());
  EXPECT_EQ(tables.table.rows.back().back().text(), "us");
}

}  // namespace
}  // namespace impinge::lab

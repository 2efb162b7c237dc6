// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: oblique rays lower strain by gap as 1 - g / (h cos psi) says, and the gap along the normal gives
// the true one back; a hip's hours hold the area that is strained, and by distance it is no less.
#include "24_strain/strain_study.hpp"

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "support/cells.hpp"

namespace impinge::lab {
namespace {

using test::number;

TEST(StrainStudy, ObliqueRaysLowerTheStrain) {
  ObliqueJoint joint;
  joint.faces = 20000;
  joint.precision_deg = 1.0;
  Table table = incidence_table();
  add_incidence(table, joint);
  ASSERT_EQ(table.rows.size(), 7U);
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const double angle = number(table, k, "angle_deg");
    EXPECT_EQ(number(table, k, "strain"), 0.5);
    EXPECT_NEAR(number(table, k, "by_gap"), number(table, k, "by_cosine"), 0.015) << angle;
    EXPECT_LT(number(table, k, "mended_error"), 0.01) << angle;
  }
  EXPECT_GT(number(table, 0, "by_gap"), 0.49);
  EXPECT_LT(number(table, 6, "by_gap"), 0.01) << "2 mm are 4 mm along the ray at 60 degrees";
}

TEST(StrainStudy, HoursOfAHipAreStrainedWhereItImpinges) {
  StrainedHip hip;
  hip.preset = "patient_a";
  hip.pose = "flexion=103.1";
  hip.faces = 1500;
  Table table = hip_strain_table();
  add_hip_strain(table, hip);
  std::map<std::string, double> hour_of_largest;
  std::map<std::string, double> largest;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const std::string cartilage = table.rows[k][2].text();
    EXPECT_GE(number(table, k, "strain_by_distance"), number(table, k, "strain") - 0.002);
    EXPECT_LE(number(table, k, "strain"), number(table, k, "largest_strain"));
    if (number(table, k, "largest_strain") <= largest[cartilage]) continue;
    largest[cartilage] = number(table, k, "largest_strain");
    hour_of_largest[cartilage] = number(table, k, "hour");
  }
  for (const std::string cartilage : {"uniform", "by_place"}) {
    EXPECT_TRUE(hour_of_largest[cartilage] == 1.0 || hour_of_largest[cartilage] == 2.0) << cartilage;
    EXPECT_GT(largest[cartilage], 0.6);
  }
  EXPECT_GT(largest["by_place"], largest["uniform"]) << "it is thicker there";
}

}  // namespace
}  // namespace impinge::lab

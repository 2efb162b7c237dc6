// SPDX-License-Identifier: GPL-3.0-or-later
// The files behind Figures 52-56: rows agree with the functions they are made of and with each other.
#include <cmath>
#include <map>
#include <numeric>
#include <string>

#include <gtest/gtest.h>

#include "07_conchoid/conchoid_facts.hpp"
#include "07_conchoid/conchoid_segments.hpp"
#include "curves/conchoid_origins.hpp"
#include "sphere/direction.hpp"
#include "support/cells.hpp"

namespace impinge::lab {
namespace {

const ConchoidShape kShape;

double number(const Result& result, std::size_t row, const std::string& column) {
  return test::number(result.table, row, column);
}

TEST(ConchoidCurve, PointsAreOnTheConchoid) {
  const Result result = conchoid_curve(kShape);
  for (std::size_t row = 0; row < result.table.rows.size(); ++row) {
    const double x = number(result, row, "x_mm");
    const double z = number(result, row, "z_mm");
    const double r = std::hypot(x, z);
    EXPECT_NEAR(r * r, kShape.a * r + kShape.b * z, 1e-9);  // r = a + b cos(phi), times r
    EXPECT_NEAR(r, number(result, row, "radius_mm"), 1e-12);
  }
  EXPECT_EQ(number(result, result.table.rows.size() - 1, "phi_deg"), 180.0);
}

TEST(ConchoidCap, AgreesWithTheCurve) {
  const Result cap = conchoid_cap(kShape);
  const Result curve = conchoid_curve(kShape);
  ASSERT_EQ(cap.table.rows.size(), 1U);
  const std::size_t rim = curve.table.rows.size() / 2;
  EXPECT_EQ(number(curve, rim, "phi_deg"), 90.0);
  EXPECT_NEAR(number(cap, 0, "quarter_over_b") * kShape.b, number(curve, rim, "length_mm"), 1e-12);
  EXPECT_NEAR(number(cap, 0, "closed_form_quarter_over_b") * kShape.b,
              number(curve, rim, "closed_form_length_mm"), 1e-12);
  EXPECT_EQ(number(cap, 0, "area_mm2"), number(curve, rim, "area_mm2"));
  EXPECT_EQ(number(cap, 0, "rim_incidence_deg"), number(curve, rim, "incidence_deg"));
}

// The segments of each origin and number of rays make up the arc.
TEST(ConchoidSegments, MakeUpTheArc) {
  constexpr std::size_t rays[] = {4, 11};
  const Result result = conchoid_segments(kShape, rays);
  std::map<std::string, double> sums;
  for (std::size_t row = 0; row < result.table.rows.size(); ++row) {
    const std::string name = test::cell(result.table, row, "origin") + test::cell(result.table, row, "rays");
    sums[name] += number(result, row, "length_mm");
  }
  EXPECT_EQ(sums.size(), 2 * sampling_origins(kShape).size());
  for (const auto& [name, sum] : sums) EXPECT_NEAR(sum, meridian_length(kShape, 0.5 * kPi), 1e-10) << name;
}

TEST(ConchoidOrigins, ExtremesHoldTheRest) {
  const Result result = conchoid_origins(kShape);
  for (std::size_t row = 0; row < result.table.rows.size(); ++row) {
    for (const char* column : {"apex_mm_per_deg", "middle_mm_per_deg", "rim_mm_per_deg"}) {
      EXPECT_LE(number(result, row, "smallest_mm_per_deg"), number(result, row, column) * (1.0 + 1e-6));
      EXPECT_GE(number(result, row, "largest_mm_per_deg"), number(result, row, column) * (1.0 - 1e-6));
    }
  }
  EXPECT_NEAR(number(result, 0, "apex_mm_per_deg"), (kShape.a + kShape.b) * kDegree, 1e-12);
}

}  // namespace
}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the study of the sampling error, on a small head.
#include "04_sampling_error/sampling_study.hpp"

#include <string>

#include <gtest/gtest.h>

#include "support/cells.hpp"

namespace impinge::lab {
namespace {

using test::number;

class Study : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    StudyOptions options;
    options.faces = 1000;
    options.uniform = 5000;
    options.polar = 200;
    options.precisions = {2.0, 1.0};
    study_ = make_sampling_study(options);
    for (const double precision : options.precisions)
      add_scheme(study_, Rsid::with_precision(precision), precision);
  }

  static SamplingStudy study_;
};

SamplingStudy Study::study_;

TEST_F(Study, FormulaAndErrorStandSideBySide) {
  ASSERT_EQ(study_.errors.rows.size(), 2U);
  EXPECT_NEAR(number(study_.errors, 1, "formula_max_mm"), 0.2715, 1e-4);
  EXPECT_NEAR(number(study_.errors, 1, "formula_relative"), 1.234, 1e-3);
  EXPECT_LT(number(study_.errors, 1, "measured_rms_mm"), number(study_.errors, 1, "measured_max_mm"));
}

TEST_F(Study, NoErrorIsAboveItsProvenBound) {
  ASSERT_EQ(study_.proven.rows.size(), 2U);
  const double bound = number(study_.proven, 1, "bound_mm");
  EXPECT_LE(number(study_.proven, 1, "measured_max_mm"), bound);
  EXPECT_LE(bound, number(study_.proven, 1, "a_priori_mm"));
  EXPECT_GT(number(study_.proven, 1, "tightness"), 1.0 / 3.0);
}

TEST_F(Study, AnErrorAboveItsBoundIsRefused) {
  SamplingStudy study;
  TableBound bound;
  bound.bound_mm = 0.5 * number(study_.proven, 1, "measured_max_mm");
  StudyCase now;
  now.scheme = "rsid";
  EXPECT_THROW(add_proven_row(study, now, number(study_.proven, 1, "measured_max_mm"), bound),
               std::runtime_error);
}

TEST_F(Study, TheFormulaAloneLeavesTheMeasuredCellsEmpty) {
  SamplingStudy formula;
  formula.errors.columns = study_.errors.columns;
  add_formula(formula, Rsid::with_precision(0.05), 0.05);
  ASSERT_EQ(formula.errors.rows.size(), 1U);
  EXPECT_NEAR(std::stod(formula.errors.rows[0][2].text()), 0.013575, 1e-6);
  EXPECT_EQ(formula.errors.rows[0][4].text() + formula.errors.rows[0][5].text(), "");
}

TEST_F(Study, ASphereAboutTheCentreHasNoRadialErrorAndItsTangentialOneIsTheFormula) {
  ASSERT_EQ(study_.sphere.rows.size(), 2U);
  EXPECT_LT(number(study_.sphere, 1, "radial_max_mm"), 1e-13);
  EXPECT_NEAR(number(study_.sphere, 1, "tangential_max_mm"), number(study_.errors, 1, "formula_max_mm"),
              1e-4);
}

TEST_F(Study, BoundsOfTheGridHold) {
  ASSERT_EQ(study_.bounds.rows.size(), 4U);
  for (const auto& row : study_.bounds.rows) EXPECT_EQ(row.back().text(), "yes") << row[1].text();
}

}  // namespace
}  // namespace impinge::lab

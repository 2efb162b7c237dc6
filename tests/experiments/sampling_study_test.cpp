// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the study of the sampling error, on a small head.
#include "04_sampling_error/sampling_study.hpp"

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "sphere/schemes/rsid.hpp"
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

  // Row of `surfaces` with this surface, precision and interpolant.
  static std::size_t row_of(const std::string& surface, double precision, const std::string& interpolant) {
    for (std::size_t r = 0; r < study_.surfaces.rows.size(); ++r) {
      const auto& row = study_.surfaces.rows[r];
      if (row[0].text() == surface && row.back().text() == interpolant &&
          number(study_.surfaces, r, "precision_deg") == precision)
        return r;
    }
    throw std::out_of_range(surface);
  }
  static double radial_max(const std::string& surface, double precision, const std::string& interpolant) {
    return number(study_.surfaces, row_of(surface, precision, interpolant), "radial_max_mm");
  }

  static SamplingStudy study_;
};

SamplingStudy Study::study_;

TEST_F(Study, FormulaAndErrorStandSideBySide) {
  ASSERT_EQ(study_.errors.rows.size(), 2U);
  EXPECT_NEAR(number(study_.errors, 1, "formula_max_mm"), 0.2715, 1e-4);
  EXPECT_NEAR(number(study_.errors, 1, "formula_relative"), 1.234, 1e-3);
  EXPECT_EQ(number(study_.errors, 1, "measured_max_mm"), radial_max("head_mesh", 1.0, "smooth"));
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
  const std::size_t row = row_of("sphere", 1.0, "smooth");
  EXPECT_LT(number(study_.surfaces, row, "radial_max_mm"), 1e-13);
  EXPECT_NEAR(number(study_.surfaces, row, "tangential_max_mm"),
              22.0 * Rsid::with_precision(1.0).covering_radius(), 1e-4);
}

// The error of the nearest entry is of first order in the precision, that of an interpolation of second.
TEST_F(Study, InterpolationGainsAnOrder) {
  for (const char* surface : {"sphere_5mm_off", "conchoid"}) {
    EXPECT_NEAR(std::log2(radial_max(surface, 2.0, "nearest") / radial_max(surface, 1.0, "nearest")), 1.0,
                0.1);
    EXPECT_NEAR(std::log2(radial_max(surface, 2.0, "smooth") / radial_max(surface, 1.0, "smooth")), 2.0, 0.1);
  }
}

// The smooth head is the truth behind the mesh: no precision takes the sagitta of its faces away.
TEST_F(Study, AgainstTheFormulaTheFacesRemain) {
  EXPECT_GT(radial_max("head_mesh_against_formula", 1.0, "smooth"), 0.1);
  EXPECT_LT(radial_max("head_formula", 1.0, "smooth"), 0.01);
}

TEST_F(Study, BoundsOfTheGridHold) {
  std::map<std::string, std::size_t> seen;
  for (const auto& row : study_.bounds.rows) {
    ++seen[row[0].text()];
    EXPECT_EQ(row.back().text(), "yes") << row[0].text() << ' ' << row[1].text();
  }
  EXPECT_EQ(seen["nearest"], 10U);
  EXPECT_EQ(seen["planar_face"], 4U);
  EXPECT_EQ(seen["planar_face_at_pole"], 4U);
  EXPECT_EQ(seen["edge"], 8U);
}

}  // namespace
}  // namespace impinge::lab

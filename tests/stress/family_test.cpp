// SPDX-License-Identifier: GPL-3.0-or-later
// The frame of families: what is listed, what makes a run fail, what is written.
#include "stress/family.hpp"

#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "stress/report.hpp"

namespace impinge::lab {
namespace {

StabilityCase clean_case(double magnitude) {
  StabilityCase c;
  c.magnitude = magnitude;
  c.method = "some";
  c.kind = "ours";
  c.questions = 10;
  c.error_over_condition_u = 0.5;
  c.threshold = 1.0;
  return c;
}

StabilityFamily family_of(std::vector<StabilityCase> cases) {
  StabilityFamily family;
  family.name = "some_family";
  family.unit = "mm";
  family.seen = {0.5, 0.25};
  family.run = [cases = std::move(cases)](const StabilityRun& /*run*/) { return cases; };
  return family;
}

std::vector<StabilityCase> clean_cases() {
  std::vector<StabilityCase> cases;
  for (int k = 0; k < 5; ++k) cases.push_back(clean_case(k));
  return cases;
}

TEST(StabilityFamilies, SayWhatTheyAreAboutBeforeTheyRun) {
  std::set<std::string> names;
  for (const StabilityFamily& family : stability_families()) {
    EXPECT_TRUE(names.insert(family.name).second) << family.name << " is there twice";
    EXPECT_FALSE(family.parameter.empty()) << family.name;
    EXPECT_FALSE(family.unit.empty()) << family.name;
    EXPECT_FALSE(family.expected.empty()) << family.name;
    EXPECT_FALSE(family.derivation.empty()) << family.name;
    EXPECT_TRUE(family.run) << family.name;
  }
  EXPECT_GE(names.size(), 9U);
}

TEST(StabilityFamilies, AFailureOfOursBreaksTheRunAndOneOfOthersDoesNot) {
  for (std::size_t StabilityCase::*count : {&StabilityCase::nan, &StabilityCase::false_hits,
                                            &StabilityCase::missed_hits, &StabilityCase::wrong}) {
    std::vector<StabilityCase> cases = clean_cases();
    EXPECT_TRUE(broken(family_of(cases), cases).empty());
    cases[2].*count = 1;
    EXPECT_EQ(broken(family_of(cases), cases).size(), 1U);
    cases[2].kind = "library";
    EXPECT_TRUE(broken(family_of(cases), cases).empty());
  }
}

TEST(StabilityFamilies, SoDoesABoundThatDoesNotHold) {
  std::vector<StabilityCase> cases = clean_cases();
  cases[1].bound_um = 1.0;
  cases[1].error_um = 1.0;
  EXPECT_TRUE(broken(family_of(cases), cases).empty());
  cases[1].error_um = 1.001;
  const auto lines = broken(family_of(cases), cases);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NE(lines[0].find("some_family at 1 mm, some in double"), std::string::npos) << lines[0];
  EXPECT_NE(lines[0].find("above the bound 1 um"), std::string::npos) << lines[0];
}

TEST(StabilityFamilies, SoDoesAnErrorOfMoreThanTwiceWhatWasSeen) {
  std::vector<StabilityCase> cases = clean_cases();
  for (StabilityCase& c : cases) c.threshold = 60.0;
  cases[1].error_over_condition_u = 1.0;
  EXPECT_TRUE(broken(family_of(cases), cases).empty());
  cases[1].error_over_condition_u = 1.001;
  const auto lines = broken(family_of(cases), cases);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NE(lines[0].find("error above 1, twice `seen` of the family"), std::string::npos) << lines[0];
  cases[1].scalar = Scalar::float32;
  cases[1].error_over_condition_u = 0.51;
  EXPECT_EQ(broken(family_of(cases), cases).size(), 1U);
  cases[1].kind = "library";
  EXPECT_TRUE(broken(family_of(cases), cases).empty());
}

TEST(StabilityFamilies, WhatIsSilentAndWhatIsWithheldIsNoFailure) {
  std::vector<StabilityCase> cases = clean_cases();
  cases[0].withheld = 7;
  cases[1].refused = "too coarse";
  EXPECT_TRUE(broken(family_of(cases), cases).empty());
}

TEST(StabilityCases, TheWorseOfTwoScenes) {
  StabilityCase a = clean_case(1.0);
  StabilityCase b = clean_case(1.0);
  a.wrong = 2;
  b.wrong = 3;
  b.error_over_condition_u = 4.0;
  a.error_um = 5.0;
  a.bound_um = 100.0;
  b.error_um = 2.0;
  b.bound_um = 1.0;
  const StabilityCase sum = worse_of({a}, {b}).front();
  EXPECT_EQ(sum.questions, 20U);
  EXPECT_EQ(sum.wrong, 5U);
  EXPECT_EQ(sum.error_over_condition_u, 4.0);
  EXPECT_FALSE(sum.bound_holds().value()) << "one of the two does not";
  b.scalar = Scalar::float32;
  EXPECT_THROW(worse_of({a}, {b}), std::logic_error);
}

TEST(StabilityReport, WritesARowACaseAndAFamily) {
  StabilityTables tables = make_stability_tables();
  std::vector<StabilityCase> cases = clean_cases();
  cases[3].missed_hits = 1;
  cases[4].refused = "too coarse";
  run_family(family_of(cases), {}, tables);
  ASSERT_EQ(tables.main.rows.size(), 5U);
  EXPECT_EQ(tables.detail.rows.size(), 5U);
  EXPECT_EQ(tables.families.rows.size(), 1U);
  EXPECT_EQ(tables.broken.size(), 1U);
  EXPECT_EQ(
      to_csv(tables.main).substr(0, to_csv(tables.main).find('\n')),
      "family,magnitude,method,scalar,condition,relative_error,error_over_condition_u,failures,bound_holds");
  EXPECT_EQ(tables.main.rows[3][7].text(), "1");
  EXPECT_EQ(tables.main.rows[4][7].text(), "") << "a refused case has no counts";
}

TEST(StabilityReport, WantsFiveMagnitudes) {
  StabilityTables tables = make_stability_tables();
  std::vector<StabilityCase> cases = clean_cases();
  cases[0].magnitude = cases[1].magnitude;
  EXPECT_THROW(run_family(family_of(cases), {}, tables), std::logic_error);
}

}  // namespace
}  // namespace impinge::lab

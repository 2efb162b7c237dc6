// SPDX-License-Identifier: GPL-3.0-or-later
// The frame of families: what is listed, what makes a run fail, what is written.
#include "stress/family.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "reference/exact_radius.hpp"
#include "sphere/infinity.hpp"
#include "sphere/radial_table.hpp"
#include "stress/measure.hpp"
#include "support/directions.hpp"
#include "support/joined.hpp"

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
  family.mutation = "a sign";
  family.run = [cases = std::move(cases)](const StabilityRun& /*run*/) { return cases; };
  return family;
}

std::vector<StabilityCase> clean_cases() {
  std::vector<StabilityCase> cases;
  for (int k = 0; k < 5; ++k) cases.push_back(clean_case(k));
  cases.push_back(clean_case(4.0));
  cases.back().kind = "mutated";
  cases.back().wrong = 1;
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
    EXPECT_FALSE(family.mutation.empty()) << family.name;
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

TEST(StabilityFamilies, SoDoesASeenThatNoRunCameNear) {
  StabilityFamily family = family_of({});
  family.seen = {1.1, 0.25};
  const auto lines = broken(family, clean_cases());
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0], "some_family: `seen` in double is above the worst, 0.500000");
  EXPECT_TRUE(broken(family, clean_cases(), 0.4).empty()) << "as a smaller run may";
}

TEST(StabilityFamilies, SoDoesAMutationThatNoCaseNotices) {
  std::vector<StabilityCase> cases = clean_cases();
  cases.back().wrong = 0;
  const auto lines = broken(family_of(cases), cases);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0], "some_family: no case notices the mutation, a sign");
  cases.back().error_um = 2.0;
  cases.back().bound_um = 1.0;
  EXPECT_TRUE(broken(family_of(cases), cases).empty()) << "a bound that does not hold is noticed";
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
  StabilityCase held = clean_case(1.0);
  held.error_um = 1.0;
  held.bound_um = 2.0;
  StabilityCase silent = clean_case(1.0);
  silent.bound_um = 2.0;
  for (const auto& [first, second] : {std::pair{held, silent}, std::pair{silent, held}})
    EXPECT_FALSE(worse_of({first}, {second}).front().bound_holds().has_value());
  EXPECT_FALSE(worse_of({silent}, {a}).front().bound_holds().has_value());
  EXPECT_FALSE(worse_of({silent}, {sum}).front().bound_holds().value_or(false));
  b.scalar = Scalar::float32;
  EXPECT_THROW(worse_of({a}, {b}), std::logic_error);
}

TEST(StabilityReport, WritesARowACaseAndAFamily) {
  StabilityTables tables = make_stability_tables();
  std::vector<StabilityCase> cases = clean_cases();
  cases[3].missed_hits = 1;
  cases[4].refused = "too coarse";
  run_family(family_of(cases), {}, tables);
  ASSERT_EQ(tables.main.rows.size(), 6U);
  EXPECT_EQ(tables.detail.rows.size(), 6U);
  EXPECT_EQ(tables.families.rows.size(), 1U);
  EXPECT_EQ(tables.broken.size(), 1U);
  EXPECT_EQ(to_csv(tables.main).substr(0, to_csv(tables.main).find('\n')),
            "family,magnitude,method,precision_deg,scalar,condition,relative_error,error_over_condition_u,"
            "failures,bound_holds");
  EXPECT_EQ(tables.main.rows[3][8].text(), "1");
  EXPECT_EQ(tables.main.rows[4][8].text(), "") << "a refused case has no counts";
}

TEST(StabilityReport, WantsFiveMagnitudes) {
  StabilityTables tables = make_stability_tables();
  std::vector<StabilityCase> cases = clean_cases();
  for (StabilityCase& c : cases) c.magnitude = std::min(c.magnitude, 3.0);
  EXPECT_THROW(run_family(family_of(cases), {}, tables), std::logic_error);
}

// Methods that are broken on purpose: each kind of failure is found, and nothing else.
//   error / (condition u) <= threshold,   condition = 1 + tan psi

StabilityScene open_scene() {
  StabilityScene scene;
  scene.mesh = cup(20.0, 60.0, 100);
  scene.directions = {
      {0.1, 0.2, 1.0}, {-0.3, 0.1, 0.9}, {0.0, 0.3, 1.1}, {0.1, 0.1, -1.0}};  // the last misses
  return scene;
}

// Answers with what it is told to.
StabilityMethod told(std::vector<double> answers) {
  StabilityMethod method;
  method.maker.name = "told";
  method.maker.kind = "ours";
  method.maker.make = [answers = std::move(answers)] {
    return PointQuery{
        [=](std::span<const Vec3>, std::span<double> out) { std::ranges::copy(answers, out.begin()); }};
  };
  return method;
}

StabilityCase measured(std::vector<double> answers, const MeasureOptions& options = {}) {
  const std::vector methods{told(std::move(answers))};
  return measure(open_scene(), 1.0, options, methods).front();
}

std::vector<double> truth() {
  const StabilityScene scene = open_scene();
  return exact_radii(scene.mesh, {scene.directions, Layer::nearest, {}});
}

TEST(Measure, TheTruthHasNoFailure) {
  const StabilityCase found = measured(truth());
  EXPECT_EQ(found.failures(), 0U);
  EXPECT_EQ(found.questions, 4U);
  EXPECT_EQ(found.relative_error, 0.0);
  EXPECT_GE(found.condition, 1.0);
  EXPECT_FALSE(found.bound_holds().has_value());
}

TEST(Measure, FindsEachKindOfFailure) {
  const std::vector<double> right = truth();
  const auto with = [&](std::size_t place, double answer) {
    std::vector<double> answers = right;
    answers[place] = answer;
    return measured(answers);
  };
  ASSERT_TRUE(std::isnan(right[3]));
  for (const double nonsense : {kInfinity, -20.0, 0.0}) {
    const StabilityCase found = with(0, nonsense);
    EXPECT_EQ(found.nan, 1U);
    EXPECT_EQ(found.failures(), 1U);
  }
  EXPECT_EQ(with(1, kNoSurface).missed_hits, 1U);
  EXPECT_EQ(with(1, kNoSurface).failures(), 1U);
  EXPECT_EQ(with(3, 20.0).false_hits, 1U);
  EXPECT_EQ(with(3, 20.0).failures(), 1U);
  EXPECT_EQ(with(2, 20.5).wrong, 1U);
  EXPECT_EQ(with(2, 20.5).failures(), 1U);
}

TEST(Measure, HalfTheThresholdFailsWhereItMust) {
  std::vector<double> answers = truth();
  const StabilityScene scene = open_scene();
  const double condition = conditions_along(scene.mesh, scene.directions)[0].condition();
  MeasureOptions options;
  answers[0] *= 1.0 + 0.75 * options.threshold * condition * 0x1p-53;
  EXPECT_EQ(measured(answers, options).wrong, 0U);
  EXPECT_NEAR(measured(answers, options).error_over_condition_u, 0.75 * options.threshold, 2.0);
  options.threshold *= 0.5;
  EXPECT_EQ(measured(answers, options).wrong, 1U);
}

TEST(Measure, TheSameDirectionTwiceHasTheSameBits) {
  StabilityScene scene = open_scene();
  scene.twins = {{0, 1}};
  std::vector<double> answers = truth();
  const auto wrong = [&] {
    const std::vector methods{told(answers)};
    return measure(scene, 1.0, {}, methods).front().wrong;
  };
  EXPECT_EQ(wrong(), 1U) << "two different radii";
  scene.twins = {{0, 0}, {3, 3}};
  EXPECT_EQ(wrong(), 0U);
}

// Look-ups of a table: a bound that is too small by any amount, and silence far from any rim.
StabilityCase look_ups(double answer, double reach, double bound_mm) {
  StabilityScene scene;
  scene.mesh = cup(20.0, 60.0, 100);  // a vertex on +z
  scene.directions = {Vec3::UnitZ()};
  StabilityMethod method = told({});
  method.maker.make = [=] {
    PointQuery query = one_by_one([=](const Vec3&) { return answer; }, 0.0);
    query.stored = [=] { return StoredRadii{{Vec3::UnitZ()}, {20.0}, reach}; };
    return query;
  };
  method.maker.bound = [=](const PointQuery&) { return MethodBound{bound_mm}; };
  const std::vector methods{method};
  return measure(scene, 1.0, {}, methods).front();
}

TEST(Measure, ABoundHoldsOrItDoesNot) {
  EXPECT_TRUE(look_ups(20.125, 0.1, 0.125).bound_holds().value());
  EXPECT_FALSE(look_ups(20.125, 0.1, 0.1249).bound_holds().value());
  EXPECT_FALSE(look_ups(20.125, 0.1, kInfinity).bound_holds().has_value());
  EXPECT_FALSE(look_ups(kNoSurface, 0.6 * 60.0 * kDegree, 1.0).bound_holds().has_value()) << "none answers";
  EXPECT_EQ(look_ups(20.125, 0.1, 0.125).failures(), 0U) << "an error of interpolation is none of rounding";
}

TEST(Measure, ATableMayBeSilentBesideARimAlone) {
  const double to_rim = 60.0 * kDegree;
  EXPECT_EQ(look_ups(kNoSurface, 0.4 * to_rim, 1.0).missed_hits, 1U);
  EXPECT_EQ(look_ups(kNoSurface, 0.6 * to_rim, 1.0).missed_hits, 0U);
  EXPECT_EQ(look_ups(kNoSurface, 0.6 * to_rim, 1.0).withheld, 1U);
}

TEST(Measure, CallsARefusalNoFailure) {
  StabilityMethod method = told({});
  method.refused = "there is no such table";
  const std::vector methods{method};
  const StabilityCase found = measure(open_scene(), 1.0, {}, methods).front();
  EXPECT_EQ(found.refused, "there is no such table");
  EXPECT_EQ(found.failures(), 0U);
}

// d ln r / d angle = tan psi; condition = 1 + tan psi.

TEST(Conditions, ASlopeIsTheDerivativeOfTheRadius) {
  const TriangleMesh mesh = octahedron(20.0);
  const Vec3 n = Vec3(1.0, 1.0, 1.0).normalized();
  for (const Vec3& any : test::random_directions(50, 9)) {
    const Vec3 u = any.cwiseAbs().normalized();         // on the face x + y + z = 20
    const Vec3 down = (n.dot(u) * u - n).normalized();  // where the radius grows fastest
    constexpr double kStep = 1e-5;
    const std::vector<Vec3> ends{u - kStep * down, u + kStep * down};
    const std::vector<double> r = exact_radii(mesh, {ends, Layer::nearest, {}});
    const double derivative = std::log(r[1] / r[0]) / (2.0 * kStep);
    EXPECT_NEAR(conditions_along(mesh, {&u, 1})[0].slope, derivative, 1e-4 * (1.0 + derivative * derivative));
    EXPECT_NEAR(conditions_along(mesh, {&u, 1})[0].slope, std::tan(angle_between(u, n)), 1e-12);
  }
}

TEST(Conditions, AtAnEdgeTheSteeperFaceCounts) {
  // The edge from x to y is in the faces z > 0, at atan(sqrt(1/2)), and z < 0, which is steeper here.
  const TriangleMesh mesh{{{20, 0, 0}, {0, 20, 0}, {0, 0, 20}, {1, 1, -1}}, {{0, 1, 2}, {1, 0, 3}}};
  const Vec3 u = Vec3(1.0, 1.0, 0.0).normalized();
  const Vec3 n = (mesh.vertices[3] - mesh.vertices[0]).cross(mesh.vertices[3] - mesh.vertices[1]);
  EXPECT_NEAR(conditions_along(mesh, {&u, 1})[0].slope, std::abs(n.cross(u).norm() / n.dot(u)), 1e-9);
  EXPECT_EQ(conditions_along(mesh, std::vector<Vec3>{{-1.0, 0.0, 0.0}})[0].slope, 0.0) << "no face";
}

TEST(Conditions, AScenesStiffnessIsThatOfItsSteepestFace) {
  TriangleMesh mesh = sphere(20.0, 500, {2.0, 0.0, 0.0});
  EXPECT_LT(stiffness(mesh), 10.0);
  test::add_face(mesh, {10.0, 0.0, 1e-6}, {12.0, 1.0, 1e-6}, {12.0, -1.0, 1e-6});
  EXPECT_GT(stiffness(mesh), 1e6);
}

}  // namespace
}  // namespace impinge::lab

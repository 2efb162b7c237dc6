// SPDX-License-Identifier: GPL-3.0-or-later
// Methods that are broken on purpose: each kind of failure is found, and nothing else.
//   error / (condition u) <= threshold,   condition = 1 + tan psi
#include "stress/measure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "reference/exact_radius.hpp"
#include "sphere/infinity.hpp"
#include "sphere/radial_table.hpp"
#include "stress/conditions.hpp"

namespace impinge::lab {
namespace {

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
  EXPECT_TRUE(look_ups(20.125, 0.1, kInfinity).bound_holds().value());
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

}  // namespace
}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of methods that are wrong in a known way, and bounds that are held against them.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "10_error_against_time/errors.hpp"
#include "methods/benchmark_scene.hpp"
#include "table/probe_directions.hpp"

namespace impinge::lab {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Answers by a function.
template <class Answer>
PointQuery formula(Answer answer) {
  return one_by_one(std::move(answer), 0.0);
}

// The truth is 20 mm everywhere but below z = -0.5, where there is no surface.
double truth_at(const Vec3& x) { return x.normalized().z() < -0.5 ? kNone : 20.0; }

BenchmarkProbes sphere_probes() {
  BenchmarkProbes probes;
  probes.points = uniform_directions(4000, 3);
  probes.uniform = 4000;
  probes.points.emplace_back(0.0, 0.0, 1.0);
  probes.truth_at = truth_at;
  for (const Vec3& x : probes.points) probes.truth.push_back(truth_at(x));
  return probes;
}

TEST(BenchmarkErrors, AreSignedAndWeightedBySolidAngle) {
  // 0.01 mm above on the upper half, 0.02 mm below on the rest.
  const PointQuery method = formula([](const Vec3& x) { return truth_at(x) + (x.z() > 0.0 ? 0.01 : -0.02); });
  const BenchmarkErrors errors = measure_errors(method, sphere_probes(), {.starts = 0});
  EXPECT_NEAR(errors.max_over, 0.01, 1e-12);
  EXPECT_NEAR(errors.max_under, 0.02, 1e-12);
  EXPECT_NEAR(errors.max(), 0.02, 1e-12);
  // The half stands for two of three parts of the covered solid angle.
  EXPECT_NEAR(errors.rms, std::sqrt((2.0 * 0.01 * 0.01 + 0.02 * 0.02) / 3.0), 3e-4);
  EXPECT_NEAR(errors.p99, 0.02, 1e-12);
  EXPECT_NEAR(errors.uniform_max, 0.02, 1e-12);
  EXPECT_NEAR(errors.feature_max, 0.01, 1e-12);
  EXPECT_EQ(errors.misses + errors.false_hits, 0U);
  EXPECT_EQ(errors.directions, 4001U);
}

TEST(BenchmarkErrors, AbsentAnswersAreCountedAndNotDropped) {
  const PointQuery method = formula([](const Vec3& x) { return x.normalized().x() > 0.8 ? kNone : 20.0; });
  const BenchmarkProbes probes = sphere_probes();
  const BenchmarkErrors errors = measure_errors(method, probes, {});
  std::size_t misses = 0;
  std::size_t false_hits = 0;
  for (const Vec3& x : probes.points) {
    misses += x.z() >= -0.5 && x.x() > 0.8 ? 1U : 0U;
    false_hits += x.z() < -0.5 && x.x() <= 0.8 ? 1U : 0U;
  }
  EXPECT_GT(misses, 300U);
  EXPECT_GT(false_hits, 900U);
  EXPECT_EQ(errors.misses, misses);
  EXPECT_EQ(errors.false_hits, false_hits);
  EXPECT_EQ(errors.max(), 0.0);
}

// An error that peaks so sharply that no probe is on top of it; the ascent gets there.
TEST(BenchmarkErrors, TheAscentFindsThePeak) {
  const Vec3 top = Vec3(0.3, -0.4, 0.6).normalized();
  const PointQuery method = formula(
      [&](const Vec3& x) { return truth_at(x) + 0.1 * std::exp(-50.0 * (x.normalized() - top).norm()); });
  const BenchmarkErrors without = measure_errors(method, sphere_probes(), {.starts = 0});
  const BenchmarkErrors with = measure_errors(method, sphere_probes(), {.starts = 4, .steps = 200});
  EXPECT_LT(without.max(), 0.09);
  EXPECT_NEAR(with.max(), 0.1, 1e-4);
  EXPECT_NEAR(with.adversarial_max, 0.1, 1e-4);
  EXPECT_EQ(without.adversarial_max, 0.0);
  EXPECT_LT((with.worst.normalized() - top).norm(), 1e-3);
  EXPECT_GT(with.directions, without.directions + 4 * 200 - 1);
}

TEST(Violation, IsAnErrorAboveTheBound) {
  BenchmarkErrors errors;
  errors.max_under = 0.002;
  errors.worst = Vec3(0.1, -0.2, 0.3);
  EXPECT_FALSE(find_violation(errors, {}));
  EXPECT_FALSE(find_violation(errors, {.bound_mm = 0.002}));
  const auto violation = find_violation(errors, {.bound_mm = 0.001});
  ASSERT_TRUE(violation);
  const auto line = nlohmann::json::parse(violation->text());
  EXPECT_DOUBLE_EQ(line["error_um"].get<double>(), 2.0);
  EXPECT_DOUBLE_EQ(line["bound_um"].get<double>(), 1.0);
  EXPECT_EQ(std::strtod(line["point_mm"][1].get<std::string>().c_str(), nullptr), -0.2);
  EXPECT_EQ(violation->text().find('\n'), std::string::npos);
  EXPECT_THROW(require_bound(errors, {.bound_mm = 0.001}, {"scene", "rsid", "1deg"}), BoundViolated);
}

}  // namespace
}  // namespace impinge::lab

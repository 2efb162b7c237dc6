// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes, probes, poses and methods of the benchmark, on a small pair.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "10_error_against_time/contact.hpp"
#include "10_error_against_time/errors.hpp"
#include "10_error_against_time/report.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/benchmark_scene.hpp"
#include "methods/points.hpp"
#include "methods/pose_set.hpp"
#include "sphere/scheme_list.hpp"
#include "table/pairwise.hpp"
#include "table/probe_directions.hpp"

namespace impinge::lab {
namespace {

TEST(MotionPose, GoesToTheEndAndBeginsAgain) {
  const Pose last = motion_pose(Vec3::UnitX(), 23);
  EXPECT_NEAR(last.rotation(1, 1), std::cos(115.0 * kDegree), 1e-12);
  EXPECT_EQ(motion_pose(Vec3::UnitX(), 24).rotation, motion_pose(Vec3::UnitX(), 0).rotation);
}

TEST(BenchmarkScenes, HipsHaveAboutTheirTriangles) {
  const BenchmarkScene hip = hip_scene("normal", 3000);
  EXPECT_EQ(hip.name, "hip_normal_3000");
  EXPECT_NEAR(static_cast<double>(hip.pair.socket.faces.size()), 3000.0, 90.0);
}

TEST(BenchmarkScenes, TheGeneratedOneIsFreeWithItsCamUnderTheSocket) {
  const double distance = surface_distance(generated_scene(1000));
  EXPECT_GT(distance, 0.5);
  EXPECT_LT(distance, 1.5) << "the joint space is 4 mm without the cam";
}

TEST(BenchmarkProbes, FeaturesAreWhereTheySay) {
  const BenchmarkScene scene = generated_scene(300);
  constexpr std::size_t kEach = 60;
  const auto directions = stratified_directions(scene.surface(), kEach);
  ASSERT_EQ(directions.size(), 6 * kEach);
  for (const Vec3& u : directions) EXPECT_NEAR(u.norm(), 1.0, 1e-14);
  const auto stratum = [&](std::size_t k) { return std::span(directions).subspan(k * kEach, kEach); };
  for (const Vec3& u : stratum(0)) {
    EXPECT_TRUE(std::ranges::any_of(scene.surface().vertices,
                                    [&](const Vec3& v) { return (v.normalized() - u).norm() < 1e-12; }));
  }
  for (const Vec3& u : stratum(2)) EXPECT_GT(std::abs(u.z()), std::cos(3.1 * kDegree));
  for (const Vec3& u : stratum(3)) EXPECT_TRUE(std::abs(u.y()) < 2e-7 && u.x() > 0.0);
  // Of the rim, some are just off the surface and some just on it.
  const RayCaster caster(scene.surface());
  std::size_t off = 0;
  for (const Vec3& u : stratum(4)) off += std::isnan(caster.cast(u, Layer::nearest)) ? 1U : 0U;
  EXPECT_GT(off, kEach / 4);
  EXPECT_LT(off, 3 * kEach / 4);
}

TEST(BenchmarkProbes, TruthIsThatOfBruteForce) {
  const BenchmarkScene scene = generated_scene(300);
  const BenchmarkProbes radial = radial_probes(scene, {200, 20, 1});
  const BenchmarkProbes euclidean = euclidean_probes(scene, {200, 20, 1});
  ASSERT_EQ(radial.points.size(), radial.truth.size());
  ASSERT_EQ(euclidean.points.size(), euclidean.truth.size());
  EXPECT_EQ(radial.uniform, 200U);
  const RayCaster caster(scene.surface());
  for (std::size_t k = 0; k < radial.points.size(); ++k) {
    const double radius = caster.cast(radial.points[k], Layer::nearest);
    ASSERT_EQ(std::isnan(radius), std::isnan(radial.truth[k]));
    EXPECT_NEAR(euclidean.truth_at(euclidean.points[k]), euclidean.truth[k], 1e-12);
    if (std::isnan(radius)) continue;
    EXPECT_NEAR(radial.truth[k], radius, 1e-12);
    // The radial distance of a point from the surface is no less than the Euclidean one.
    EXPECT_LE(euclidean.truth[k], std::abs(radius - euclidean.points[k].norm()) + 1e-12);
  }
}

TEST(BenchmarkMethods, HaveEverySchemeInEveryStorageUnderItsOwnName) {
  const BenchmarkScene scene = generated_scene(300);
  std::set<std::string> schemes;
  std::set<std::string> mesh_exact;
  std::set<std::string> keys;
  std::size_t count = 0;
  PointSizes sizes;
  sizes.tables.precisions = {4.0, 2.0};
  for (const PointCase& maker : cases_of(points_methods(), &Method::points, scene, sizes)) {
    if (maker.kind != "ours") continue;
    ++count;
    (maker.interpolant == "smooth" ? schemes : mesh_exact).insert(maker.name);
    EXPECT_TRUE(keys.insert(maker.name + '/' + maker.setting).second) << maker.name << maker.setting;
  }
  std::size_t all = 0;
  for_each_scheme([&]<class S>() {
    ++all;
    EXPECT_TRUE(schemes.contains(std::string(S::name)));
    EXPECT_EQ(mesh_exact.contains(std::string(S::name) + "_mesh_exact"), PlaneExactScheme<S>);
  });
  EXPECT_EQ(schemes.size(), all);
  EXPECT_TRUE(keys.contains("rsid/4deg"));
  EXPECT_TRUE(keys.contains("cube_gnomonic_mesh_exact/2deg uint16"));
  EXPECT_EQ(count, 2 * 3 * (schemes.size() + mesh_exact.size()));
}

// Errors of methods that are wrong in a known way, and bounds that are held against them.

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

// Contract: close to contact too every answer is that of the exact test of every vertex; what FCL finds
// beyond it is a contact of the surfaces, of which that test misses some.

TEST(ContactAgreement, VerticesMissContactsOfTheSurfacesAndNothingElseDiffers) {
  const AgreementOptions options{300, 200, 5};
  const Agreement found = contact_agreement(make_ball_socket_pair(options.triangles), options);
  EXPECT_EQ(found.poses, 200U);
  EXPECT_GT(found.impinged, 40U);
  EXPECT_LT(found.impinged, 160U);
  EXPECT_EQ(found.culled_wrong, 0U);
  EXPECT_EQ(found.least_gap_wrong, 0U);
  EXPECT_EQ(found.unexplained, 0U);
  EXPECT_GT(found.missed, 0U);
  EXPECT_GE(found.missed, found.between_vertices);
  EXPECT_EQ(agreement_table(options, found).rows.size(), 1U);
}

}  // namespace
}  // namespace impinge::lab

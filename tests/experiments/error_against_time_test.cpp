// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes, probes, poses and methods of the benchmark, on a small pair.
#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "10_error_against_time/all_gaps.hpp"
#include "10_error_against_time/probes.hpp"
#include "methods/points.hpp"
#include "methods/surface_distance.hpp"
#include "sphere/scheme_list.hpp"
#include "table/pairwise.hpp"

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

}  // namespace
}  // namespace impinge::lab

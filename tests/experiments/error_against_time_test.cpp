// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes, probes, methods and costs of the benchmark, on a small pair.
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "10_error_against_time/report.hpp"
#include "methods/benchmark_scene.hpp"
#include "methods/surface_distance.hpp"
#include "sphere/scheme_list.hpp"
#include "table/pairwise.hpp"

namespace impinge::lab {
namespace {

PointSizes tables_of(std::vector<double> precisions_deg) {
  PointSizes sizes;
  sizes.tables.precisions = std::move(precisions_deg);
  return sizes;
}

std::vector<PointCase> methods_of(const BenchmarkScene& scene, const PointSizes& sizes) {
  return cases_of(points_methods(), &Method::points, scene, sizes);
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
  for (const PointCase& maker : methods_of(scene, tables_of({4.0, 2.0}))) {
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

// One method of each kind on its own: fewer bytes for fewer bits, and bounds that hold.
TEST(BenchmarkMethods, KeepTheirBounds) {
  const BenchmarkScene scene = generated_scene(300);
  const BenchmarkProbes radial = radial_probes(scene, {1000, 50, 1});
  const BenchmarkProbes euclidean = euclidean_probes(scene, {100, 20, 1});
  std::map<std::string, double> bytes;
  std::size_t bounded = 0;
  PointSizes sizes = tables_of({4.0});
  sizes.tables.most_entries = 100000;
  sizes.tables.most_faces = 1000;
  sizes.grid_nodes = {8};
  for (const PointCase& maker : methods_of(scene, sizes)) {
    if (maker.kind == "ours" && maker.scheme != "rsid" && maker.scheme != "cube_gnomonic") continue;
    const PointQuery query = maker.make();
    bytes[maker.name + '/' + maker.setting] = query.bytes;
    const BenchmarkErrors errors =
        measure_errors(query, maker.measure == Measure::radial ? radial : euclidean, {.starts = 2});
    EXPECT_LT(errors.misses, errors.directions / 10) << maker.name;
    if (!maker.bound) continue;
    const MethodBound bound = maker.bound(query);
    const auto violation = find_violation(errors, bound);
    EXPECT_FALSE(violation) << maker.name << ' ' << maker.setting << ' ' << violation->text();
    bounded += std::isfinite(bound.bound_mm) ? 1U : 0U;
  }
  EXPECT_GE(bounded, 6U);
  EXPECT_GT(bytes["rsid/4deg"], 1.8 * bytes["rsid/4deg float"]);
  EXPECT_GT(bytes["rsid/4deg float"], 1.8 * bytes["rsid/4deg uint16"]);
}

// Half of what is proven of a table does not hold: the bound is nearly attained, and the ascent gets there.
TEST(BenchmarkMethods, HalfOfATablesBoundIsViolated) {
  const BenchmarkScene scene = generated_scene(300);
  const BenchmarkProbes radial = radial_probes(scene, {2000, 200, 1});
  PointSizes sizes = tables_of({4.0});
  sizes.tables.most_entries = 100000;
  sizes.tables.most_faces = 1000;
  for (const PointCase& maker : methods_of(scene, sizes)) {
    if (maker.name != "cube_gnomonic" && maker.name != "cube_gnomonic_mesh_exact") continue;
    const PointQuery query = maker.make();
    const BenchmarkErrors errors = measure_errors(query, radial, {.starts = 4});
    MethodBound bound = maker.bound(query);
    EXPECT_FALSE(find_violation(errors, bound)) << maker.name << ' ' << maker.setting;
    bound.bound_mm *= 0.5;
    EXPECT_TRUE(find_violation(errors, bound)) << maker.name << ' ' << maker.setting;
  }
}

// Every method without a table: a row in both tables, and samples of each cost.
TEST(BenchmarkReport, HasErrorsAndThreeCostsOfEveryMethod) {
  const BenchmarkScene scene = generated_scene(300);
  BenchmarkOptions options;
  options.radial = options.euclidean = {100, 5, 1};
  options.ascent.starts = 1;
  options.timing.rounds = 2;
  options.timing.options = {.min_round_ms = 0.1, .most_repeats = 0};
  options.timing.slow_build_ms = 0.0;  // every building is slow
  BenchmarkTables tables = make_benchmark_tables();
  Progress quiet("test", nullptr);
  run_benchmark(scene, options, tables, quiet);
  const std::size_t methods = methods_of(scene, options.sizes).size();
  ASSERT_GE(methods, 10U);
  EXPECT_EQ(tables.main.table.rows.size(), methods);
  EXPECT_EQ(tables.spread.rows.size(), methods);
  ASSERT_EQ(tables.main.timing.timings.size(), 3 * methods);
  for (const Timing& timing : tables.main.timing.timings) {
    ASSERT_EQ(timing.key.size(), cost_keys().size());
    EXPECT_EQ(timing.samples_ms.size(), timing.key.back().text() == "build" ? 1U : 2U);
    EXPECT_GT(timing.summary.median, 0.0) << key_text(timing.key);
  }
}

TEST(BenchmarkReport, ABoundThatDoesNotHoldEndsTheRun) {
  Violation violation;
  violation.method = "rsid";
  violation.error_mm = 2.0;
  violation.bound_mm = 1.0;
  const BoundViolated thrown(violation);
  EXPECT_NE(std::string(thrown.what()).find("rsid"), std::string::npos);
  EXPECT_EQ(thrown.violation().text(), violation.text());
}

}  // namespace
}  // namespace impinge::lab

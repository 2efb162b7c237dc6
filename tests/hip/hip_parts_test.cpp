// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: parts are closed bodies behind the main surface, which they leave as it is; they stand where the
// parameters say; rays enter and leave them where their faces are.
#include "hip/hip_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "mesh/validation.hpp"
#include "support/directions.hpp"
#include "support/hip_with_parts.hpp"

namespace impinge {
namespace {

// By brute force over the faces: the first and the last crossing, NaN where there is none.
std::array<double, 2> crossings(const TriangleMesh& mesh, const Vec3& u) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const Face& face : mesh.faces) {
    const auto [a, b, c] = corners_of(mesh, face);
    Eigen::Matrix3d corners;
    corners << a, b, c;
    const Vec3 weights = corners.inverse() * u;  // of the corners, for the point 1 / sum along u
    if (weights.minCoeff() < 0.0) continue;
    least = std::min(least, 1.0 / weights.sum());
    most = std::max(most, 1.0 / weights.sum());
  }
  if (most < least) return {std::nan(""), std::nan("")};
  return {least, most};
}

TEST(HipParts, LeaveTheMainSurfaceAsItIs) {
  const BallSocketPair without = [] {
    Hip hip = make_hip({}, 2000);
    EXPECT_TRUE(hip.ball_parts.empty() && hip.socket_parts.empty());
    return BallSocketPair{hip.ball, hip.socket};
  }();
  const Hip hip = make_hip(test::hip_with_parts(), 2000);
  const BallSocketPair main = main_surfaces(hip);
  EXPECT_EQ(main.ball.vertices, without.ball.vertices);
  EXPECT_EQ(main.ball.faces, without.ball.faces);
  EXPECT_EQ(main.socket.vertices, without.socket.vertices);
  EXPECT_EQ(main.socket.faces, without.socket.faces);
  ASSERT_EQ(hip.ball_parts.size(), 2U);
  ASSERT_EQ(hip.socket_parts.size(), 1U);
  for (std::size_t k = 0; k < hip.ball_parts.size(); ++k) {
    const MeshReport report = validate(part_surface(hip.ball, hip.ball_parts, k));
    EXPECT_GT(report.volume.value(), 0.0) << "closed, normals outward";
  }
  EXPECT_GT(validate(part_surface(hip.socket, hip.socket_parts, 0)).volume.value(), 0.0);
}

// Tables 11 to 13 and all other results are of hips without them.
TEST(HipParts, NoPresetHasThem) {
  for (const std::string_view name : hip_preset_names()) {
    const Hip hip = make_hip(hip_preset(name), 1000);
    EXPECT_TRUE(hip.ball_parts.empty() && hip.socket_parts.empty()) << name;
  }
}

double highest(const TriangleMesh& mesh, const Vec3& way) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Vec3& x : mesh.vertices) most = std::max(most, way.dot(x));
  return most;
}

// Lengths that were published, taken from the meshes.
TEST(HipParts, StandWhereTheParametersSay) {
  const HipParameters p = test::hip_with_parts();
  const HipSurface surface = hip_surface(p);
  const Hip hip = make_hip(p, 12000);
  const TriangleMesh greater = part_surface(hip.ball, hip.ball_parts, 0);
  EXPECT_NEAR(highest(greater, Vec3::UnitZ()), p.greater_trochanter_tip, 0.05);
  const Vec3 out = Vec3(surface.neck.x(), surface.neck.y(), 0.0).normalized();
  const Vec3 back(out.y(), -out.x(), 0.0);
  EXPECT_NEAR(highest(greater, back) + highest(greater, -back), p.greater_trochanter_width, 0.1);
  const std::vector<BonePart> parts = femur_parts(surface);
  const Vec3 tip = parts[0].middle + parts[0].axes.col(2);
  EXPECT_NEAR(tip.dot(out), 46.2, 1e-9);
  EXPECT_NEAR(tip.dot(back), p.greater_trochanter_behind, 1e-9);
  EXPECT_LT(back.y(), 0.0) << "behind";
  const Vec3 lesser = parts[1].middle + parts[1].axes.col(0);
  EXPECT_NEAR((lesser - tip).norm(), 67.5, 1e-9);
  EXPECT_LT(lesser.y(), p.neck_length * surface.neck.y()) << "behind the shaft";
  EXPECT_LT(lesser.x(), p.neck_length * surface.neck.x()) << "medial of it";

  const TriangleMesh spine = part_surface(hip.socket, hip.socket_parts, 0);
  const double rim = surface.socket_radius * std::cos(p.half_opening * kDegree);
  EXPECT_NEAR(highest(spine, surface.opening), p.aiis_height - rim, 0.05);
  const Vec3 middle = acetabulum_parts(surface)[0].middle;
  EXPECT_NEAR(surface.rim_clock.hours(middle), p.aiis_clock, 1e-9);
  const double from_axis = (middle - middle.dot(surface.opening) * surface.opening).norm();
  EXPECT_NEAR(from_axis - surface.socket_radius * std::sin(p.half_opening * kDegree), p.aiis_distance, 1e-9);
}

TEST(HipParts, RaysCrossThemWhereTheirFacesAre) {
  const HipSurface surface = hip_surface(test::hip_with_parts());
  std::vector<BonePart> parts = femur_parts(surface);
  parts.push_back(acetabulum_parts(surface).front());
  for (const BonePart& part : parts) {
    const TriangleMesh mesh = mesh_of(part, 0.8);
    std::size_t met = 0;
    for (const Vec3& v : mesh.vertices) {
      const Vec3 u = (v + part.middle).normalized();  // well inside
      const auto [least, most] = crossings(mesh, u);
      EXPECT_NEAR(part.nearest(u), least, 0.1);
      EXPECT_NEAR(part.farthest(u), most, 0.1);
      EXPECT_TRUE(std::isnan(part.nearest(-u)) && std::isnan(part.farthest(-u)));
      ++met;
    }
    EXPECT_GT(met, 100U);
  }
}

}  // namespace
}  // namespace impinge

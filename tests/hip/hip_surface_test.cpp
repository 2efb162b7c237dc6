// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms behind a generated hip, R the head's radius, rho the neck's, w the angle from the neck axis:
//   neck            n . (0, 0, -1) = cos(180 - CCD); torsion is the angle of n from lateral, seen from above
//   bare neck       alpha = asin(rho / 1.02 R)
//   cam             R + h cos^2(pi/2 t / W) = 1.02 R at t from its top
//   flat rim        LCE = half opening - inclination, without version
//   ellipsoid       (w.n / q)^2 + |w x n|^2 = R^2
//   conchoid        |x| = a + b cos(angle to its axis), from its origin
#include "hip/hip_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_parts.hpp"
#include "hip/hip_presets.hpp"
#include "mesh/validation.hpp"
#include "support/directions.hpp"
#include "support/hip_with_parts.hpp"

namespace impinge {
namespace {

TEST(HipSurface, NeckPointsDownOutwardAndBack) {
  const HipSurface hip = hip_surface({.neck_shaft_angle = 130.0, .femoral_torsion = 15.0});
  EXPECT_NEAR(hip.neck.z(), -std::cos(50.0 * kDegree), 1e-12);
  EXPECT_NEAR(std::atan2(-hip.neck.y(), hip.neck.x()) / kDegree, 15.0, 1e-12);
  EXPECT_GT(hip.neck.x(), 0.0);
}

TEST(HipSurface, OpeningLooksOutDownAndForward) {
  const HipSurface hip = hip_surface({.inclination = 50.0, .version = 20.0});
  EXPECT_NEAR(std::atan2(hip.opening.x(), -hip.opening.z()) / kDegree, 50.0, 1e-12);
  EXPECT_NEAR(std::atan2(hip.opening.y(), hip.opening.x()) / kDegree, 20.0, 1e-12);
}

TEST(HipSurface, AlphaOfABareNeck) {
  const HipSurface hip = hip_surface({.head_radius = 25.0, .head_neck_offset = 8.0, .neck_fillet = 0.0});
  for (const double hours : {0.0, 1.5, 4.0, 9.0})
    EXPECT_NEAR(alpha_angle_deg(hip, hours), std::asin(17.0 / 25.5) / kDegree, 1e-9);
}

TEST(HipSurface, AlphaOfACam) {
  const HipParameters p = hip_preset("cam");
  const HipSurface hip = hip_surface(p);
  const double share = std::sqrt(kAlphaShare * p.head_radius / p.cam_height);
  const double expected = p.cam_polar + p.cam_half_width * std::acos(share) * 2.0 / kPi;
  EXPECT_NEAR(alpha_angle_deg(hip, p.cam_clock), expected, 1e-9);
  EXPECT_NEAR(head_radius(hip, clock_direction(hip.neck, hip.neck_clock, p.cam_polar * kDegree, p.cam_clock)),
              p.head_radius + p.cam_height, 1e-12);
}

TEST(HipSurface, AFlatRimIsRaisedOnlyToAnotherCentreEdgeAngle) {
  HipParameters p{.inclination = 52.0, .version = 0.0, .half_opening = 85.0, .lateral_centre_edge = 33.0};
  const HipSurface flat = hip_surface(p);
  for (int k = 0; k < 48; ++k) EXPECT_NEAR(rim_polar(flat, k / 4.0), 85.0 * kDegree, 1e-9);
  p.lateral_centre_edge = 25.0;
  const HipSurface low = hip_surface(p);
  EXPECT_NEAR(rim_polar(low, low.lateral_clock), 77.0 * kDegree, 1e-9);
  EXPECT_NEAR(rim_polar(low, low.lateral_clock + 6.0), 85.0 * kDegree, 1e-9);
}

TEST(HipSurface, APincerAddsItsHeight) {
  HipParameters p;
  p.pincer_height = 4.0;
  p.pincer_clock = 4.0;
  const HipSurface hip = hip_surface(p);
  const double base = p.half_opening * kDegree;
  EXPECT_NEAR((rim_polar(hip, 4.0) - base) * hip.socket_radius, 4.0, 1e-9);
  EXPECT_NEAR((rim_polar(hip, 5.0) - base) * hip.socket_radius, 2.0, 1e-9);  // half way to its end
  EXPECT_NEAR(rim_polar(hip, 6.5), base, 1e-12);
}

TEST(HipSurface, AnEllipsoidHead) {
  const HipSurface hip = hip_surface({.head_axis_ratio = 0.95});
  for (const Vec3& u : test::random_directions(200, 5)) {
    if (angle_between(u, hip.neck) < 1.2) continue;
    const Vec3 x = head_neck_radius(hip, u) * u;
    EXPECT_NEAR(std::hypot(x.dot(hip.neck) / 0.95, x.cross(hip.neck).norm()), 24.0, 1e-9);
  }
}

// Menschik's conchoid; its cap of 90 degrees is close to a sphere of 25.2 mm.
TEST(HipSurface, AConchoidHead) {
  const HipParameters p{.conchoid_a = 20.501, .conchoid_b = 17.843};
  const HipSurface hip = hip_surface(p);
  EXPECT_NEAR(hip.head_radius, 25.2, 0.1);
  const Hip made = make_hip(p, 3000);
  std::size_t checked = 0;
  for (const Vec3& v : made.ball.vertices) {
    if (v.dot(hip.neck) > 0.0) continue;
    const Vec3 x = v - hip.conchoid_origin * hip.neck;
    const double cosine = -x.dot(hip.neck) / x.norm();
    EXPECT_NEAR(x.norm(), p.conchoid_a + p.conchoid_b * cosine, 1e-9);
    EXPECT_NEAR(v.norm(), hip.head_radius, 0.8);
    ++checked;
  }
  EXPECT_GT(checked, 300U);
}

// Contract: parts are closed bodies behind the main surface, which they leave as it is; they stand where the
// parameters say; rays enter and leave them where their faces are.

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

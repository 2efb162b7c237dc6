// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms behind a generated hip, R the head's radius, rho the neck's, w the angle from the neck axis:
//   neck            n . (0, 0, -1) = cos(180 - CCD); torsion is the angle of n from lateral, seen from above
//   bare neck       alpha = asin(rho / 1.02 R)
//   cam             R + h cos^2(pi/2 t / W) = 1.02 R at t from its top
//   flat rim        LCE = half opening - inclination, without version
//   ellipsoid       (w.n / q)^2 + |w x n|^2 = R^2
//   conchoid        |x| = a + b cos(angle to its axis), from its origin
#include "hip/hip_surface.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "support/directions.hpp"

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

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// One signed gap for both scans: g(u) = S(u) - B(u). A ball moved by t in a socket about the origin:
// g = |x| - |x - t| type closed forms, checked per vertex.
#include "gap/gap_scan.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "gap/gap_summary.hpp"
#include "mesh/bodies.hpp"
#include "sphere/schemes/rsid.hpp"
#include "table/exact_raster.hpp"

namespace impinge {
namespace {

constexpr std::size_t kFaces = 20000;
constexpr double kSagitta = 0.03;  // mm; how far the faces of these spheres lie inside of them

struct Scans {
  std::vector<double> ball;
  std::vector<double> socket;
};

Scans scan(const TriangleMesh& ball, const TriangleMesh& socket, const Pose& pose) {
  const Rsid scheme = Rsid::with_precision(0.5);
  Scans gaps{std::vector<double>(ball.vertices.size()), std::vector<double>(socket.vertices.size())};
  scan_gaps(fill_exact(socket, scheme, Layer::nearest), ball.vertices, pose, Surface::ball, gaps.ball);
  scan_gaps(fill_exact(ball, scheme, Layer::farthest), socket.vertices, pose, Surface::socket, gaps.socket);
  return gaps;
}

// Ball of radius B moved by t: a ball vertex at R v + t meets the socket, a sphere S about the origin, at S -
// |R v + t|; a socket vertex w, seen from the ball's centre, meets the ball at |w - t| - B.
TEST(GapScan, MovedBallHasTheClosedFormGap) {
  const TriangleMesh ball = sphere(22.0, kFaces);
  const TriangleMesh socket = sphere(26.0, kFaces);
  const Pose pose{Eigen::AngleAxisd(0.8, Vec3(1, -2, 0.5).normalized()).toRotationMatrix(), {3.0, -2.0, 4.0}};
  const Scans gaps = scan(ball, socket, pose);
  for (std::size_t i = 0; i < ball.vertices.size(); ++i) {
    EXPECT_NEAR(gaps.ball[i], 26.0 - (pose.rotation * ball.vertices[i] + pose.translation).norm(), kSagitta);
  }
  for (std::size_t i = 0; i < socket.vertices.size(); ++i) {
    EXPECT_NEAR(gaps.socket[i], (socket.vertices[i] - pose.translation).norm() - 22.0, kSagitta);
  }
  // |t| = 5.39 is more than the joint space of 4: the smallest gap is 4 - |t|.
  EXPECT_NEAR(*std::ranges::min_element(gaps.ball), 4.0 - pose.translation.norm(), 2 * kSagitta);
  EXPECT_NEAR(*std::ranges::min_element(gaps.socket), 4.0 - pose.translation.norm(), 2 * kSagitta);
}

// An asymmetric ball, so that a rotation taken the wrong way round shows.
TEST(GapScan, RotationTurnsTheBallInTheSocket) {
  const Vec3 e(6.0, 0.0, 0.0);
  const TriangleMesh ball = sphere(18.0, kFaces, e);
  const TriangleMesh socket = sphere(26.0, kFaces);
  const Pose quarter{Eigen::AngleAxisd(kPi / 2.0, Vec3::UnitZ()).toRotationMatrix(), Vec3::Zero()};  // x to y
  const Scans gaps = scan(ball, socket, quarter);
  for (std::size_t i = 0; i < socket.vertices.size(); ++i) {
    const Vec3 u = socket.vertices[i].normalized();
    EXPECT_NEAR(gaps.socket[i], 26.0 - eccentric_sphere_radius(u, 18.0, {0.0, 6.0, 0.0}), 2 * kSagitta);
  }
  for (std::size_t i = 0; i < ball.vertices.size(); ++i) {
    EXPECT_NEAR(gaps.ball[i], 26.0 - ball.vertices[i].norm(), kSagitta);
  }
}

TEST(GapScan, NoSurfaceIsNeverAHit) {
  const TriangleMesh ball = sphere(22.0, kFaces);
  const TriangleMesh socket = cup(26.0, 60.0, kFaces);
  const Scans gaps = scan(ball, socket, {});
  for (std::size_t i = 0; i < ball.vertices.size(); ++i) {
    const double phi = to_angles(ball.vertices[i]).phi;
    if (phi > 60.0 * kDegree) {
      EXPECT_TRUE(std::isnan(gaps.ball[i])) << phi / kDegree;
    }
    if (phi < 59.0 * kDegree) {
      EXPECT_NEAR(gaps.ball[i], 4.0, kSagitta);
    }
  }
  EXPECT_EQ(std::ranges::count_if(gaps.socket, [](double g) { return std::isnan(g); }), 0);
}

TEST(GapSummary, CountsWhatIsAtMostTheThreshold) {
  const std::vector<double> gap{3.0, kNoSurface, -0.5, 4.0, 4.5, kNoSurface};
  const std::vector<double> area{1.0, 2.0, 4.0, 8.0, 16.0, 32.0};
  const GapSummary at_4 = summarise(gap, area, 4.0);
  EXPECT_EQ(at_4.smallest, 2U);
  EXPECT_EQ(at_4.smallest_gap, -0.5);
  EXPECT_EQ(at_4.met, 4U);
  EXPECT_EQ(at_4.impinged, 3U);
  EXPECT_EQ(at_4.impinged_area, 13.0);
  EXPECT_EQ(summarise(gap, area, 0.0).impinged, 1U);
  const std::vector<double> none{kNoSurface};
  EXPECT_FALSE(summarise(none, std::vector<double>{1.0}, 4.0).smallest);
}

}  // namespace
}  // namespace impinge

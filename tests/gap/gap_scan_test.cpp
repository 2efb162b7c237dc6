// SPDX-License-Identifier: GPL-3.0-or-later
// One signed gap for both scans: g(u) = S(u) - B(u). A ball moved by t in a socket about the origin:
// g = |x| - |x - t| type closed forms, checked per vertex.
#include "gap/gap_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "gap/gap_histogram.hpp"
#include "gap/gap_summary.hpp"
#include "gap/simd/joint_scan.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
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

// Contract: scan_joint() gives what the two scans of gap/gap_scan.hpp give, but for rounding in double.

constexpr double kRounding = 1e-10;  // mm: |v| and the steps of the table times some thousand times 2^-53

void expect_near(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  std::size_t met = 0;
  std::size_t otherwise = 0;  // on a grid line the scalar look-up may answer beside a cell without surface
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (std::isnan(found[i]) != std::isnan(expected[i])) ++otherwise;
    if (std::isnan(found[i]) || std::isnan(expected[i])) continue;
    ++met;
    EXPECT_NEAR(found[i], expected[i], kRounding) << "vertex " << i;
  }
  EXPECT_GT(met, found.size() / 4);
  EXPECT_LE(otherwise, 2U);
}

TEST(JointScan, IsBothScansOfAPose) {
  const BallSocketPair pair = make_ball_socket_pair(3000);
  const Rsid scheme = Rsid::with_precision(1.0);
  const auto ball_table = fill_exact(pair.ball, scheme, Layer::farthest);
  const auto socket_table = fill_exact(pair.socket, scheme, Layer::nearest);
  const auto joint = packed_joint(packed_table<double>(ball_table), packed_table<double>(socket_table),
                                  pair.ball, pair.socket);
  Pose pose;
  pose.rotation = Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  pose.translation = Vec3(0.3, -0.2, 0.4);
  std::vector<double> ball_gap(pair.ball.vertices.size());
  std::vector<double> socket_gap(pair.socket.vertices.size());
  std::vector<double> ball_expected(ball_gap.size());
  std::vector<double> socket_expected(socket_gap.size());
  scan_joint(joint, pose, ball_gap, socket_gap);
  scan_gaps(socket_table, pair.ball.vertices, pose, Surface::ball, ball_expected);
  scan_gaps(ball_table, pair.socket.vertices, pose, Surface::socket, socket_expected);
  expect_near(ball_gap, ball_expected);
  expect_near(socket_gap, socket_expected);
}

// Contract: bin k holds the area of gaps in [first + k width, first + (k + 1) width); all parts together hold
// the whole area.

TEST(GapHistogram, PutsAreasIntoTheirBins) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> gap{-5.0, -4.5001, -0.1, 0.0, 0.49, 0.5, 14.99, 15.0, -5.01, none, infinity};
  const std::vector<double> area{1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024};
  const GapHistogram found = gap_histogram(gap, area);
  EXPECT_EQ(found.area[0], 3.0);
  EXPECT_EQ(found.area[9], 4.0);
  EXPECT_EQ(found.area[10], 24.0);
  EXPECT_EQ(found.area[11], 32.0);
  EXPECT_EQ(found.area[39], 64.0);
  EXPECT_EQ(found.beyond, 1152.0);
  EXPECT_EQ(found.below, 256.0);
  EXPECT_EQ(found.without, 512.0);
}

TEST(GapHistogram, HoldsTheWholeArea) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> spread(4.0, 6.0);
  std::vector<double> gap(5000);
  for (double& g : gap) g = spread(random);
  const GapHistogram found = gap_histogram(gap, std::vector<double>(gap.size(), 0.5));
  const double inside = std::accumulate(found.area.begin(), found.area.end(), 0.0);
  EXPECT_EQ(inside + found.below + found.beyond + found.without, 2500.0);
  EXPECT_GT(inside, 2000.0);
  EXPECT_GT(found.below, 0.0);
}

}  // namespace
}  // namespace impinge

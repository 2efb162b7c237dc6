// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: scan_joint() gives what the two scans of gap/gap_scan.hpp give, but for rounding in double;
// of tables of corners, but for what gap/simd/corner_table.hpp and a vertex moved in float allow:
//   u (20 (r + |x|) + 5 Q r + 13 m D) + 2^-15 (D + r / m) + E (1 + 2 m D / |x|),   E = 10.4 u (|v| + |t|)
#include "gap/simd/joint_scan.hpp"

#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "gap/corner_fixture.hpp"
#include "gap/gap_scan.hpp"
#include "mesh/generated_pair.hpp"
#include "support/poses.hpp"
#include "table/exact_raster.hpp"

namespace impinge {
namespace {

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

// Largest difference of neighbours along rows and columns of the faces: two of them are no less than D.
double largest_step(const RadialTable<CubeGnomonic>& table) {
  const std::size_t lines = table.scheme().divisions() + 1;
  const auto radii = table.radii();
  double largest = 0.0;
  for (std::size_t e = 0; e + lines < radii.size(); ++e) {
    if (e % lines + 1 < lines) largest = std::fmax(largest, std::abs(radii[e + 1] - radii[e]));
    if (e / lines % lines + 1 < lines) largest = std::fmax(largest, std::abs(radii[e + lines] - radii[e]));
  }
  return largest;
}

// The scan of a surface's vertices in the stored table of the other one.
struct CornerScan {
  const RadialTable<CubeGnomonic>& stored;
  const TriangleMesh& moved;
  double sign;   // gap = sign (r - |x|)
  double range;  // Q, or more
};

void expect_corners(const CornerScan& scan, const Pose& pose, const std::vector<float>& gap) {
  const InverseDepthTable<CubeGnomonic> scalar(scan.stored);
  const auto m = static_cast<double>(scan.stored.scheme().divisions());
  const double step = 2.0 * largest_step(scan.stored);
  std::size_t met = 0;
  std::size_t otherwise = 0;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    const Vec3& v = scan.moved.vertices[i];
    const Vec3 x = scan.sign > 0.0 ? to_socket(pose, v) : to_ball(pose, v);
    const double radius = scalar.radius_at(x);
    const double length = x.norm();
    if (std::isnan(gap[i]) != std::isnan(radius)) ++otherwise;
    if (std::isnan(gap[i]) || std::isnan(radius)) continue;
    ++met;
    const double moved = 10.4 * (v.norm() + pose.translation.norm()) * (1.0 + 2.0 * m * step / length);
    const double rounding = 20.0 * (radius + length) + 5.0 * scan.range * radius + 13.0 * m * step + moved;
    EXPECT_NEAR(gap[i], scan.sign * (radius - length), 0x1p-24 * rounding + 0x1p-15 * (step + radius / m));
  }
  EXPECT_GT(met, gap.size() / 4);
  EXPECT_LE(otherwise, gap.size() / 100);
}

TEST(JointScan, BothScansOverCornersInAnyPose) {
  const BallSocketPair pair = make_ball_socket_pair(1000);
  const auto scheme = CubeGnomonic::with_precision(2.0);
  const auto ball = fill_exact(pair.ball, scheme, Layer::farthest);
  const auto socket = fill_exact(pair.socket, scheme, Layer::nearest);
  const auto corners = [](const RadialTable<CubeGnomonic>& radii) {
    return corner_table(packed_table<float>(radii));
  };
  const auto joint = packed_joint(corners(ball), corners(socket), pair.ball, pair.socket);
  const auto ball_stored = test::stored_radii(joint.ball_table, ball);
  const auto socket_stored = test::stored_radii(joint.socket_table, socket);
  std::vector<float> ball_gap(pair.ball.vertices.size());
  std::vector<float> socket_gap(pair.socket.vertices.size());
  for (const Pose& pose : test::random_poses(10, 3.0, 2.0, 5)) {
    scan_joint(joint, pose, ball_gap, socket_gap);
    expect_corners({socket_stored, pair.ball, 1.0, 3.0}, pose, ball_gap);
    expect_corners({ball_stored, pair.socket, -1.0, 3.0}, pose, socket_gap);
  }
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: scan_joint() gives what the two scans of gap/gap_scan.hpp give, but for rounding in double.
#include "gap/simd/joint_scan.hpp"

#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "gap/gap_scan.hpp"
#include "mesh/generated_pair.hpp"
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

}  // namespace
}  // namespace impinge

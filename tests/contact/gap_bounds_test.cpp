// SPDX-License-Identifier: GPL-3.0-or-later
// What a search rests on:
//   moved()       every vertex of a node is within `angle` of the middle, and |x| <= length for the ball, >=
//   for
//                 the socket
//   gap_bounds()  no vertex of a node has a gap below `gap`; `open` are the nodes for which !(gap > enough)
#include "contact/gap_bounds.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "contact/culled_joint.hpp"
#include "mesh/generated_pair.hpp"
#include "sphere/infinity.hpp"
#include "support/cap_nodes.hpp"
#include "support/poses.hpp"

namespace impinge {
namespace {

TEST(MovedCaps, HoldTheirVertices) {
  const BallSocketPair joint{test::bumpy(400, 8.0), test::bumpy(400, 8.0)};
  for (const double shift : {0.0, 4.0, 24.0, 60.0}) {
    for (const Pose& pose : test::random_poses(3, 3.0, shift, 36)) {
      for (const Surface scanned : {Surface::ball, Surface::socket}) {
        const bool ball = scanned == Surface::ball;
        const CulledScan scan(scanned, ball ? joint.ball : joint.socket, ball ? joint.socket : joint.ball);
        const CapMove move(scanned, pose);
        test::for_each_node(scan.tree(), [&](const CapNode& node, const CapBlock& block, std::size_t lane) {
          const MovedCaps caps = moved(block, move);
          const Vec3 middle(caps.x[lane], caps.y[lane], caps.z[lane]);
          const bool any = !(caps.angle[lane] < 4.0F);
          for (const std::uint32_t k : test::items_below(scan.tree(), node)) {
            const Vec3 x = move.place(scan.position(k));
            EXPECT_LE(ball ? x.norm() : caps.length[lane], ball ? caps.length[lane] : x.norm());
            EXPECT_LE(any ? 0.0 : angle_between(middle, x),
                      any ? 0.0 : static_cast<double>(caps.angle[lane]));
          }
        });
      }
    }
  }
}

// A cap of that angle, of one radius, whose axis is b away from +z.
CapBlock one_cap(float angle, double b) {
  CapBlock block;
  for (CapLanes* all : {&block.x, &block.y, &block.z, &block.spread}) all->fill(0.0F);
  block.x.fill(static_cast<float>(std::sin(b)));
  block.z.fill(static_cast<float>(std::cos(b)));
  block.angle.fill(angle);
  for (CapLanes* radius : {&block.low, &block.high, &block.mean}) radius->fill(22.0F);
  block.nodes = 1;
  return block;
}

// The largest |s w + o| of directions w within an angle of an axis b away from o is that for
//   w.o = T cos(max(b - angle, 0)),
// the least that for T cos(min(b + angle, pi)). No bound is closer than that but for its rounding, and up to
// half a radian they are as close as 40 um.
TEST(MovedCaps, LengthsAreThoseOfTheEdge) {
  for (const double shift : {0.5, 4.0, 8.0}) {
    const Pose pose{Eigen::Matrix3d::Identity(), Vec3(0.0, 0.0, shift)};
    const auto length = [&](double cosine) {
      return std::sqrt(22.0 * 22.0 + 2.0 * 22.0 * shift * cosine + shift * shift);
    };
    for (double b = 0.0; b < kPi; b += 0.02) {
      for (const float angle : {0.0F, 1e-4F, 1e-3F, 0.02F, 0.1F, 0.3F, 0.5F, 1.0F, 2.0F, 3.14F}) {
        const double most = length(std::cos(std::max(b - static_cast<double>(angle), 0.0)));
        const double least = length(std::cos(std::min(kPi - b + static_cast<double>(angle), kPi)));
        const CapBlock block = one_cap(angle, b);
        const double ball = moved(block, CapMove(Surface::ball, pose)).length[0];
        const double socket = moved(block, CapMove(Surface::socket, pose)).length[0];
        const double close = angle <= 0.5F ? 0.04 : kInfinity;
        EXPECT_GE(ball, most - 1e-6);
        EXPECT_LE(ball, most + close);
        EXPECT_LE(socket, least + 1e-6);
        EXPECT_GE(socket, least - close);
      }
    }
  }
}

// In poses near and far.
TEST(GapBounds, NoVertexHasASmallerGap) {
  const BallSocketPair joint = make_ball_socket_pair(300, impinging_cam());
  const CulledJoint culled(joint);
  for (const double shift : {0.0, 3.0, 23.0}) {
    for (const Pose& pose : test::random_poses(3, 3.0, shift, 37)) {
      for (const CulledScan& scan : culled.scans()) {
        const CapMove move(scan.scanned(), pose);
        test::for_each_node(scan.tree(), [&](const CapNode& node, const CapBlock& block, std::size_t lane) {
          const GapBounds bounds = gap_bounds(block, move, scan.limits(), 1.0F);
          EXPECT_EQ(((bounds.open >> lane) & 1U) != 0, !(bounds.gap[lane] > 1.0F));
          EXPECT_EQ(bounds.open >> block.nodes, 0U);
          for (const std::uint32_t item : test::items_below(scan.tree(), node)) {
            const double gap = culled.gap(scan.scanned(), move.place(scan.position(item)));
            EXPECT_FALSE(gap < bounds.gap[lane]);  // NaN: none
          }
        });
      }
    }
  }
}

// Between a ball of 22 and one of 26 mm a gap of 4 mm is known to be as large but for the height of the
// faces, in caps of any width.
TEST(GapBounds, AreTightBetweenSpheres) {
  const BallSocketPair joint{sphere(22.0, 3000), sphere(26.0, 3000)};
  const CulledJoint culled(joint);
  const CapMove move(Surface::ball, {});
  const CulledScan& scan = culled.scans()[0];
  for (const CapBlock& block : scan.tree().blocks()) {
    const GapBounds bounds = gap_bounds(block, move, scan.limits(), 5.0F);
    for (std::size_t lane = 0; lane < block.nodes; ++lane) EXPECT_NEAR(bounds.gap[lane], 4.0F, 0.1F);
  }
}

// Where the ball of 22 mm is moved by 2 mm along z, the gap beside direction a is 4 mm less a_z of 2 mm; seen
// from the ball the socket comes nearer at the same place.
TEST(GapBounds, ATouchIsLikeliestWhereTheBallIsMovedTo) {
  const BallSocketPair joint{sphere(22.0, 1000), sphere(26.0, 1000)};
  const CulledJoint culled(joint);
  const Pose pose{Eigen::Matrix3d::Identity(), Vec3(0.0, 0.0, 2.0)};
  for (const CulledScan& scan : culled.scans()) {
    for (const CapBlock& block : scan.tree().blocks()) {
      const GapBounds bounds = gap_bounds(block, CapMove(scan.scanned(), pose), scan.limits(), 0.0F);
      for (std::size_t lane = 0; lane < block.nodes; ++lane)
        EXPECT_NEAR(bounds.likely[lane], 4.0F - 2.0F * block.z[lane], 0.3F);
    }
  }
}

}  // namespace
}  // namespace impinge

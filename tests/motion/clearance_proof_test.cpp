// SPDX-License-Identifier: GPL-3.0-or-later
// What a proof says of a pose, held against the exact overlay of the surfaces and the exact radii of the
// reference; the text is checked by its own checker in e2e.certificate.
#include "motion/clearance_proof.hpp"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "gap/overlay.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "mesh/icosphere.hpp"
#include "motion/turn_limit.hpp"
#include "reference/exact_radius.hpp"
#include "support/dice.hpp"
#include "support/directions.hpp"
#include "support/poses.hpp"
#include "support/soup.hpp"

namespace impinge {
namespace {

const BallSocketPair& hip() {
  static const BallSocketPair pair = [] {
    const Hip made = make_hip(hip_preset("cam"), 600);
    return BallSocketPair{made.ball, made.socket};
  }();
  return pair;
}

// Rotations and shifts as a proof has rounded them.
Pose rounded(const ClearanceProof& proof) { return {rotation_of(proof.outer), proof.shift}; }

// The leaf of a direction by its definition; null where there is none, or several of which one lies inside.
const ClearLeaf* leaf_of(const std::vector<ClearLeaf>& leaves, const Vec3& u) {
  Eigen::Index k = 0;
  u.cwiseAbs().maxCoeff(&k);
  const double m = std::abs(u[k]);
  const auto place = [&](Eigen::Index next, int level) {
    const auto n = static_cast<double>(1 << level);
    return static_cast<std::int64_t>(std::floor(0.5 * n * (u[(k + next) % 3] / m + 1.0)));
  };
  const ClearLeaf* found = nullptr;
  for (const ClearLeaf& leaf : leaves) {
    if (leaf.face != 2 * k + (u[k] < 0.0 ? 1 : 0)) continue;
    if (leaf.i != place(1, leaf.level) || leaf.j != place(2, leaf.level)) continue;
    if (found != nullptr) return nullptr;
    found = &leaf;
  }
  return found;
}

void expect_apart(const std::vector<ClearLeaf>& leaves, const BallSocketPair& posed,
                  const std::vector<Vec3>& directions) {
  const std::vector<double> ball = exact_radii(posed.ball, {directions, Layer::farthest});
  const std::vector<double> socket = exact_radii(posed.socket, {directions, Layer::nearest});
  for (std::size_t d = 0; d < directions.size(); ++d) {
    const ClearLeaf* leaf = leaf_of(leaves, directions[d]);
    ASSERT_NE(leaf, nullptr) << directions[d].transpose();
    const double radius = static_cast<double>(leaf->radius) / static_cast<double>(kLeafUnit);
    if (std::isfinite(ball[d])) {
      EXPECT_LE(ball[d], radius) << directions[d].transpose();
    }
    if (std::isfinite(socket[d])) {
      EXPECT_GT(socket[d], radius) << directions[d].transpose();
    }
  }
}

void expect_a_partition(const std::vector<ClearLeaf>& leaves) {
  std::map<int, double> area;
  for (const ClearLeaf& leaf : leaves) area[leaf.face] += std::ldexp(1.0, -2 * leaf.level);
  EXPECT_EQ(area.size(), 6);
  for (const auto& [face, sum] : area) EXPECT_EQ(sum, 1.0) << face;
}

TEST(ClearanceProof, SaysOfRandomPosesWhatTheExactOverlaySays) {
  const SurfaceOverlay overlay(hip().ball, hip().socket);
  std::size_t clear = 0;
  std::size_t blocked = 0;
  std::size_t open = 0;
  for (const Pose& pose : test::random_poses(150, 1.6, 0.0, 5)) {
    const ClearanceProof proof = prove_pose({hip(), Vec3::Zero()}, pose);
    const bool impinged = overlay.impinged(rounded(proof));
    EXPECT_LT(proof.rounded_deg, 2e-4);
    if (proof.open) {
      ++open;
    } else if (proof.ray) {
      ++blocked;
      EXPECT_TRUE(impinged);
    } else {
      ++clear;
      EXPECT_FALSE(impinged);
      ASSERT_EQ(proof.cells.size(), 1);
      expect_a_partition(proof.cells[0].leaves);
    }
  }
  EXPECT_GT(clear, 30);
  EXPECT_GT(blocked, 30);
  EXPECT_LT(open, 3);
}

TEST(ClearanceProof, HasARadiusBetweenTheExactOnesInEveryDirection) {
  for (const Pose& pose : test::random_poses(4, 0.6, 0.0, 8)) {
    const ClearanceProof proof = prove_pose({hip(), Vec3::Zero()}, pose);
    if (proof.ray || proof.open) continue;
    const BallSocketPair posed{test::ball_in_socket_frame(hip().ball, rounded(proof)), hip().socket};
    std::vector<Vec3> directions = test::random_directions(2000, 3);
    const std::vector<Vec3> corners = test::feature_directions(posed.ball);
    directions.insert(directions.end(), corners.begin(), corners.end());
    expect_apart(proof.cells[0].leaves, posed, directions);
  }
}

TEST(ClearanceProof, OfAShiftedPoseIsAboutEachCentre) {
  const SurfaceOverlay overlay(hip().ball, hip().socket);
  std::size_t clear = 0;
  std::size_t blocked = 0;
  for (const Pose& pose : test::random_poses(60, 1.2, 5.0, 9)) {
    const ClearanceProof proof = prove_pose({hip(), Vec3::Zero()}, pose);
    if (proof.open) continue;
    EXPECT_EQ(overlay.impinged(rounded(proof)), proof.ray.has_value());
    clear += proof.ray ? 0U : 1U;
    blocked += proof.ray ? 1U : 0U;
    if (proof.ray) continue;
    ASSERT_EQ(proof.cells.size(), 2);
    for (const ProofCell& cell : proof.cells) {
      expect_a_partition(cell.leaves);
      const Pose pose_here = rounded(proof);
      BallSocketPair here{test::ball_in_socket_frame(hip().ball, pose_here), hip().socket};
      if (cell.about == Surface::ball)
        here = {relative_to(here.ball, proof.shift), relative_to(here.socket, proof.shift)};
      expect_apart(cell.leaves, here, test::random_directions(200, 4));
    }
  }
  EXPECT_GT(clear, 5);
  EXPECT_GT(blocked, 5);
}

// Layers over layers, rims everywhere, faces near the centre and across it.
TEST(ClearanceProof, NeverCallsASoupClearThatIsNot) {
  std::size_t clear = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    TriangleMesh ball = test::soup(3, seed);
    for (Vec3& x : ball.vertices) x *= 0.4;
    const BallSocketPair pair{ball, test::soup(4, seed + 1000)};
    const SurfaceOverlay overlay(pair.ball, pair.socket);
    const ClearanceProof proof = prove_pose({pair, Vec3::Zero()}, Pose{});
    if (proof.open) continue;
    EXPECT_EQ(overlay.impinged(Pose{}), proof.ray.has_value()) << seed;
    clear += proof.ray ? 0U : 1U;
  }
  EXPECT_GT(clear, 20);
}

// The same sphere in a larger one: what is proven from which gap on.
TEST(ClearanceProof, NeedsAClearance) {
  const auto said = [](double gap, const Vec3& centre) {
    const BallSocketPair pair{icosphere(24.0, 3), icosphere(24.0 + gap, 3)};
    const ClearanceProof proof = prove_pose({pair, centre}, Pose{});
    return proof.ray ? -1 : proof.open ? 0 : 1;
  };
  const Vec3 far(2e5, 0.0, 0.0);  // where reading may round by 0.08 mm
  EXPECT_EQ(said(0.0, Vec3::Zero()), 0);
  EXPECT_EQ(said(1e-5, Vec3::Zero()), 0);  // reading may have closed it
  EXPECT_EQ(said(0.05, Vec3::Zero()), 1);
  EXPECT_EQ(said(-0.05, Vec3::Zero()), -1);
  EXPECT_EQ(said(0.05, far), 0);
  EXPECT_EQ(said(-0.05, far), 0);
  EXPECT_EQ(said(0.5, far), 1);
  EXPECT_EQ(said(-0.9, far), -1);
}

TEST(ClearanceProof, OfATurnHoldsForEveryAngle) {
  const SurfaceOverlay overlay(hip().ball, hip().socket);
  const JointTurn turn = joint_turn({.flexion = 60.0}, motion_name("internal_rotation"), Side::right);
  const TurnLimit limit = TurnLimits(hip()).first_contact(turn, 180.0);
  ASSERT_EQ(limit.state, LimitState::limited);
  const double last = limit.low_deg - 0.1;
  const ClearanceProof proof = prove_turn({hip(), Vec3::Zero()}, turn, last);
  ASSERT_FALSE(proof.open);
  EXPECT_NEAR(proof.end_deg(), last, 1e-4);
  EXPECT_LT(proof.rounded_deg, 2e-4);
  test::Dice random(3);
  HalfAngle end{1, 0};
  for (const ProofCell& cell : proof.cells) {
    EXPECT_EQ(cell.from, end);
    end = cell.to;
    expect_a_partition(cell.leaves);
    const auto degrees = [](const HalfAngle& half) {
      return 2.0 * std::atan2(static_cast<double>(half[1]), static_cast<double>(half[0])) / kDegree;
    };
    for (const double share : {0.0, random.between(0.0, 1.0), random.between(0.0, 1.0), 1.0}) {
      const double angle = degrees(cell.from) + share * (degrees(cell.to) - degrees(cell.from));
      const Pose pose{
          rotation_of(proof.outer) * Eigen::AngleAxisd(angle * kDegree, turn.axis) * rotation_of(proof.inner),
          Vec3::Zero()};
      EXPECT_FALSE(overlay.impinged(pose)) << angle;
      expect_apart(cell.leaves, {test::ball_in_socket_frame(hip().ball, pose), hip().socket},
                   test::random_directions(100, 7));
    }
  }
}

TEST(ClearanceProof, OfATurnStopsBeforeContact) {
  const JointTurn turn = joint_turn({.flexion = 60.0}, motion_name("internal_rotation"), Side::right);
  const TurnLimit limit = TurnLimits(hip()).first_contact(turn, 180.0);
  const ClearanceProof proof = prove_turn({hip(), Vec3::Zero()}, turn, limit.high_deg + 1.0);
  EXPECT_TRUE(proof.open);
  EXPECT_LE(proof.end_deg(), limit.high_deg);
  EXPECT_GT(proof.end_deg(), limit.low_deg - 0.1);
}

}  // namespace
}  // namespace impinge

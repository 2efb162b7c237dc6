// SPDX-License-Identifier: GPL-3.0-or-later
// Along a motion, and from any pose to any other, CoherentContact says what CulledJoint says of each pose by
// itself, and no pose within a certified step of a clear one is impinged.
#include "contact/coherent_contact.hpp"

#include <gtest/gtest.h>

#include "harness/contact_poses.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "support/poses.hpp"

namespace impinge {
namespace {

using namespace lab;

// Poses that impinge.
std::size_t expect_same_answers(const CulledJoint& joint, const std::vector<Pose>& poses) {
  CoherentContact coherent(joint);
  std::size_t impinged = 0;
  for (const Pose& pose : poses) {
    const auto found = coherent.impinged(pose);
    EXPECT_EQ(found.has_value(), joint.impinged(pose).has_value());
    impinged += found ? 1U : 0U;
    if (!found) continue;
    const bool ball = found->scanned == Surface::ball;
    const Vec3 x = ball ? to_socket(pose, joint.meshes().ball.vertices[found->vertex])
                        : to_ball(pose, joint.meshes().socket.vertices[found->vertex]);
    EXPECT_TRUE(joint.exactly_impinged(found->scanned, x));
    EXPECT_EQ(coherent.certified_step(), 0.0);
  }
  return impinged;
}

// There and back, so that it is impinged in the middle of the way.
std::vector<Pose> motion(const PosePath& path, int steps) {
  std::vector<Pose> poses;
  for (int k = 0; k <= 2 * steps; ++k)
    poses.push_back(path.at(static_cast<double>(k <= steps ? k : 2 * steps - k) / steps));
  return poses;
}

TEST(CoherentContact, AnswersAsIndependentPosesAlongMotions) {
  const BallSocketPair meshes = make_ball_socket_pair(400, impinging_cam());
  const CulledJoint joint(meshes);
  std::size_t impinged = 0;
  std::size_t all = 0;
  for (const Vec3& shift : {Vec3(0, 0, 0), Vec3(3, 1, 2), Vec3(0.2, -0.1, 4.5), Vec3(-9, 2, 1)}) {
    for (const double turn : {0.0, 1.2, -2.5}) {
      const auto poses = motion({Vec3(0.2, 1.0, -0.1).normalized(), 0.0, turn, shift}, 200);
      impinged += expect_same_answers(joint, poses);
      all += poses.size();
    }
  }
  EXPECT_GT(impinged, all / 10);
  EXPECT_LT(impinged, all - all / 10);
}

// A thousandth of a millimetre and less from one pose to the next, across the first contact.
TEST(CoherentContact, AnswersAsIndependentPosesAcrossContact) {
  const BallSocketPair meshes = make_ball_socket_pair(300);
  const CulledJoint joint(meshes);
  for (const Vec3& way : {Vec3(1, 2, 6), Vec3(-4, 0, 4), Vec3(0, -6, 1)}) {
    PosePath path;
    path.from_turn = path.to_turn = 0.7;
    path.shift = 2.0 * way;
    const auto contact =
        first_contact(path, [&](const Pose& pose) { return joint.impinged(pose).has_value(); });
    ASSERT_TRUE(contact);
    std::vector<Pose> poses;
    for (int k = 0; k < 60; ++k) poses.push_back(path.at(*contact + 1e-5 * (k - 40)));
    EXPECT_EQ(expect_same_answers(joint, poses), 20U);
  }
}

TEST(CoherentContact, AnswersAsIndependentPosesFromAnyPoseToAnyOther) {
  const BallSocketPair meshes = make_ball_socket_pair(200);
  const CulledJoint joint(meshes);
  for (const double shift : {2.0, 5.0, 30.0})
    expect_same_answers(joint, test::random_poses(60, 3.0, shift, 41));
  const BallSocketPair alike{octahedron(16.0), octahedron(16.0)};
  expect_same_answers(CulledJoint(alike), test::random_poses(5, 1.0, 1.0, 42));
}

// The same pose again and again uses nothing up; small motions use up what they are.
TEST(CoherentContact, ACertifiedStepStaysClear) {
  const BallSocketPair meshes = make_ball_socket_pair(400);
  const CulledJoint joint(meshes);
  CoherentContact coherent(joint);
  std::size_t steps = 0;
  for (const Pose& pose : test::random_poses(40, 3.0, 3.9, 43)) {
    if (coherent.impinged(pose)) continue;
    const double step = coherent.certified_step();
    coherent.impinged(pose);
    EXPECT_EQ(coherent.certified_step(), step);
    Pose moved = pose;
    for (const Vec3& way : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0.6, 0.8)}) {
      moved.translation = pose.translation + step / (1.0 + CoherentContact::kLever / (21.5 - 8.0)) * way;
      EXPECT_FALSE(joint.impinged(moved));
    }
    steps += step > 0.05 ? 1U : 0U;
  }
  EXPECT_GT(steps, 10U);
}

// Little is looked at again while a motion is far from contact.
TEST(CoherentContact, AProofIsUsedUpByAsMuchMotion) {
  const BallSocketPair meshes = make_ball_socket_pair(400);
  const CulledJoint joint(meshes);
  CoherentContact coherent(joint);
  Pose pose;
  ASSERT_FALSE(coherent.impinged(pose));
  const double step = coherent.certified_step();
  const double turn = 0.5 * step / CoherentContact::kLever;
  pose.rotation = Eigen::AngleAxisd(turn, Vec3(1, 2, 2) / 3.0).toRotationMatrix();
  ASSERT_FALSE(coherent.impinged(pose));
  EXPECT_NEAR(coherent.certified_step(), 0.5 * step, 1e-9);
}

}  // namespace
}  // namespace impinge

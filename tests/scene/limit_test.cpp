// SPDX-License-Identifier: GPL-3.0-or-later
// The limit that a scene tells is that of the library, in the frame of the user's files.
#include "scene/limit.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limits/turn_limit.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge {
namespace {

const Vec3 kAt(100.0, -40.0, 7.0);

// A generated pair about kAt in a frame LPS.
Joint scanned_joint(const PairShape& shape) {
  BallSocketPair pair = make_ball_socket_pair(800, shape);
  const Eigen::Matrix3d axes = input_to_joint("LPS");
  for (TriangleMesh* mesh : {&pair.ball, &pair.socket}) {
    for (Vec3& x : mesh->vertices) x = axes.transpose() * x;
  }
  Joint joint;
  joint.ball.mesh = pair.ball;
  joint.socket.mesh = pair.socket;
  joint.centre = kAt;
  return joint;
}

SceneOptions abducted() {
  SceneOptions options;
  options.axes = "LPS";
  options.side = Side::right;
  options.limit = &motion_name("abduction");
  options.cartilage_mm = 2.0;
  return options;
}

TEST(SceneLimit, IsThatOfTheLibraryInTheFrameOfTheFiles) {
  const auto summary = limit_summary(abducted(), scanned_joint(impinging_cam()));
  const TurnLimits limits(make_ball_socket_pair(800, impinging_cam()));
  const JointTurn turn = joint_turn({}, motion_name("abduction"), Side::right);
  const TurnLimit expected = limits.first_contact(turn, 180.0);
  const auto& contact = summary["contact"][0];
  EXPECT_EQ(contact["state"], "reached");
  EXPECT_EQ(contact["centre"], "ball");
  EXPECT_NEAR(contact["low_deg"].get<double>(), expected.low_deg, 1e-9);
  EXPECT_NEAR(contact["high_deg"].get<double>(), expected.high_deg, 1e-9);
  const Vec3 place = input_to_joint("LPS").transpose() * expected.contact->place + kAt;
  EXPECT_NEAR(contact["position"]["x"].get<double>(), place.x(), 1e-6);
  EXPECT_NEAR(contact["position"]["z"].get<double>(), place.z(), 1e-6);
  EXPECT_NEAR(contact["uncertainty_deg"].get<double>(), 0.5 * expected.deg_per_mm, 1e-6);
  EXPECT_NEAR(summary["cartilage"]["low_deg"].get<double>(), limits.gap_of(turn, 2.0, 180.0).low_deg, 1e-9);
  EXPECT_NEAR(summary["contact"][1]["low_deg"].get<double>(), expected.low_deg, 0.5) << "one centre, fitted";
  const std::string text = describe_limits(summary);
  EXPECT_NE(text.find("of abduction"), std::string::npos) << text;
  EXPECT_NE(text.find("\ngap of 2 mm         between "), std::string::npos) << text;  // as wide as the others
}

TEST(SceneLimit, SaysFreeAndBlocked) {
  SceneOptions options = abducted();
  options.cartilage_mm = 5.0;  // above the joint space
  const auto summary = limit_summary(options, scanned_joint({}));
  EXPECT_EQ(summary["contact"][0]["state"], "free");
  EXPECT_EQ(summary["contact"][0]["high_deg"], 180.0);
  EXPECT_EQ(summary["cartilage"]["state"], "blocked");
  const std::string text = describe_limits(summary);
  EXPECT_NE(text.find("none up to 180"), std::string::npos) << text;
  EXPECT_NE(text.find("before it begins"), std::string::npos) << text;
}

}  // namespace
}  // namespace impinge

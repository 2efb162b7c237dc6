// SPDX-License-Identifier: GPL-3.0-or-later
// The limit that a scene tells is that of the library, in the frame of the user's files.
#include "scene/limit.hpp"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "limits/told_limit.hpp"
#include "mesh/generated_pair.hpp"

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

// An answer, and what is said of it.
struct Told {
  LimitAnswers found;
  nlohmann::json summary;
  std::string text;
};

Told told_of(const SceneOptions& options, Joint joint) {
  Session session(std::move(joint), options.side, options.axes);
  const LimitAnswers found = answer_limits(session, limit_request(options));
  return {found, limit_summary(options, *session.joint, found, 0.0), describe_limits(options, found)};
}

TEST(SceneLimit, IsThatOfTheLibraryInTheFrameOfTheFiles) {
  const auto [found, summary, text] = told_of(abducted(), scanned_joint(impinging_cam()));
  const TurnLimits limits(make_ball_socket_pair(800, impinging_cam()));
  const JointTurn turn = joint_turn({}, motion_name("abduction"), Side::right);
  const TurnLimit expected = limits.first_contact(turn, 180.0);
  const auto& contact = summary["contact"][0];
  EXPECT_EQ(contact["state"], "limited");
  EXPECT_EQ(contact["centre"], "ball");
  EXPECT_NEAR(contact["low_deg"].get<double>(), expected.low_deg, 1e-9);
  EXPECT_NEAR(contact["high_deg"].get<double>(), expected.high_deg, 1e-9);
  const Vec3 place = input_to_joint("LPS").transpose() * expected.contact->place + kAt;
  EXPECT_NEAR(contact["position"]["x"].get<double>(), place.x(), 1e-6);
  EXPECT_NEAR(contact["position"]["z"].get<double>(), place.z(), 1e-6);
  const ToldLimit told = told_limit(limits, turn, 0.0, 180.0);
  EXPECT_NEAR(contact["half_mm_gap_deg"].get<double>(), *told.half_mm_gap_deg, 1e-9);
  EXPECT_LT(*told.half_mm_gap_deg, expected.low_deg);
  EXPECT_NEAR(contact["centre_low_deg"].get<double>(), told.common.low_deg, 1e-9);
  EXPECT_NEAR(contact["play_low_deg"].get<double>(), told.play.low_deg, 1e-9);
  EXPECT_NEAR(contact["centre_of_rotation"]["y"].get<double>(), kAt.y(), 1e-9);
  EXPECT_FALSE(contact.contains("uncertainty_deg"));
  for (const char* key : {"centre", "side", "axes", "pose", "motion", "question", "ball", "socket"})
    EXPECT_TRUE(summary.contains(key)) << key;
  EXPECT_EQ(summary["side"], "right");
  EXPECT_EQ(summary["axes"], "LPS");
  EXPECT_EQ(summary["centre"]["x"], kAt.x());
  EXPECT_NEAR(summary["cartilage"]["low_deg"].get<double>(), limits.gap_of(turn, 2.0, 180.0).low_deg, 1e-9);
  EXPECT_NEAR(summary["contact"][1]["low_deg"].get<double>(), expected.low_deg, 0.5) << "one centre, fitted";
  EXPECT_NE(text.find("of abduction"), std::string::npos) << text;
  EXPECT_NE(text.find("\ngap of 2 mm         between "), std::string::npos) << text;  // as wide as the others
}

TEST(SceneLimit, SaysFreeAndBlocked) {
  SceneOptions options = abducted();
  options.cartilage_mm = 5.0;  // above the joint space
  const auto [found, summary, text] = told_of(options, scanned_joint({}));
  EXPECT_EQ(summary["contact"][0]["state"], "free");
  EXPECT_EQ(summary["contact"][0]["high_deg"], 180.0);
  EXPECT_EQ(summary["cartilage"]["state"], "blocked");
  EXPECT_NE(text.find("none up to 180"), std::string::npos) << text;
  EXPECT_NE(text.find("before it begins"), std::string::npos) << text;
}

// A limit that a graze makes: what is said must tell that half a millimetre changes it.
TEST(SceneLimit, FlagsWhatHangsOnLessThanHalfAMillimetre) {
  PairShape grazing;  // the cam passes under the socket's rim less than 0.1 mm away from it
  grazing.cam_height = 3.95;
  const auto [found, summary, text] = told_of(abducted(), scanned_joint(grazing));
  const auto& contact = summary["contact"][0];
  EXPECT_EQ(contact["state"], "free");
  EXPECT_LT(contact["half_mm_gap_deg"].get<double>(), 60.0);
  EXPECT_TRUE(contact["hangs_on_less_than_half_mm"].get<bool>());
  EXPECT_NE(text.find("sensitive to less than 0.5 mm"), std::string::npos) << text;
  grazing.cam_height = 3.0;  // a whole millimetre
  const auto clear = told_of(abducted(), scanned_joint(grazing)).summary;
  EXPECT_TRUE(clear["contact"][0]["half_mm_gap_deg"].is_null());
  EXPECT_FALSE(clear["contact"][0]["hangs_on_less_than_half_mm"].get<bool>());
}

// A ball that is a cap: where it ends nothing is known.
TEST(SceneLimit, SaysWhereTheBallsMeshEnds) {
  Joint joint = scanned_joint({});
  TriangleMesh& ball = joint.ball.mesh;
  std::erase_if(ball.faces, [&](const Face& f) { return corner(ball, f, 0).z() < -6.0; });
  const auto [found, summary, text] = told_of(abducted(), joint);
  const auto& contact = summary["contact"][0];
  EXPECT_EQ(contact["state"], "unknown");
  EXPECT_EQ(contact["low_deg"], contact["leaves_ball_mesh_deg"]);
  EXPECT_NE(text.find("leaves the ball's mesh at "), std::string::npos) << text;
  EXPECT_NE(text.find("unknown beyond"), std::string::npos) << text;
}

// A limit beyond the mesh of a cap is that of the cap: no later for more of the ball, but perhaps earlier.
TEST(SceneLimit, SaysThatWhatIsMissingMayComeFirst) {
  const char* said = "degrees on: what is missing may come first";
  Joint joint = scanned_joint(impinging_cam());
  EXPECT_EQ(told_of(abducted(), joint).text.find(said), std::string::npos);
  TriangleMesh& ball = joint.ball.mesh;
  std::erase_if(ball.faces, [&](const Face& f) { return corner(ball, f, 0).z() < -8.0; });
  const auto [found, summary, text] = told_of(abducted(), joint);
  const auto& cartilage = summary["cartilage"];
  EXPECT_EQ(cartilage["state"], "limited");
  EXPECT_LT(cartilage["leaves_ball_mesh_deg"], cartilage["low_deg"]);
  EXPECT_NE(text.find(said), std::string::npos) << text;
}

// Ends of what is proven are no higher, or no lower, than they are: 53.56 is "not before 53.5".
TEST(SceneLimit, IsToldOutward) {
  const SceneOptions options = abducted();
  LimitAnswers found = told_of(options, scanned_joint(impinging_cam())).found;
  ToldLimit& told = found.contact.told;
  told.limit.low_deg = 53.56789;
  told.limit.high_deg = 53.56791;
  told.common = {40.06, 60.04, true};
  told.play = {41.06, 0.0, false};
  told.half_mm_gap_deg = 42.06;
  told.limit.leaves_mesh_deg = 43.06;
  std::string text = describe_limits(options, found);
  for (const char* said : {"between 53.5678 and 53.5680 degrees", ": 40.0 to 60.1 degrees",
                           "none before 41.0 degrees", "0.5 mm at 42.0 degrees", "from 43.0 degrees on"})
    EXPECT_NE(text.find(said), std::string::npos) << said << " in\n" << text;
  told.limit.state = LimitState::unknown;
  EXPECT_NE(describe_limits(options, found).find("leaves the ball's mesh at 53.5 degrees"),
            std::string::npos);
  told.limit.leaves_mesh_deg.reset();
  EXPECT_NE(describe_limits(options, found).find("none up to 53.5 degrees, where"), std::string::npos);
  told.limit.state = LimitState::free;
  EXPECT_NE(describe_limits(options, found).find("none up to 53.5 degrees,"), std::string::npos);
}

}  // namespace
}  // namespace impinge

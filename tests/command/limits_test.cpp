// SPDX-License-Identifier: GPL-3.0-or-later
// The limit that is told is that of the library, in the frame of the user's files.
#include "joint/limits.hpp"

#include <utility>

#include <gtest/gtest.h>

#include "joint/joint_document.hpp"
#include "limits/told_limit.hpp"
#include "mesh/generated_pair.hpp"
#include "support/command_line.hpp"
#include "support/opened.hpp"
#include "support/temporary_folder.hpp"

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
  joint.axes = "LPS";
  return joint;
}

Session session_of(const PairShape& shape) { return {scanned_joint(shape), Side::right, "LPS"}; }

Told abducted(Session session, double cartilage_mm = 2.0) {
  const QuestionCommand question = test::asked(limits_question(), "--motions abduction");
  question.use_cartilage(cartilage_mm);
  return question.ask(session, {});
}

TEST(LimitsCommand, IsThatOfTheLibraryInTheFrameOfTheFiles) {
  Session session = session_of(impinging_cam());
  const Json joint = json_of(describe(*session.joint, {}));
  const Told found = abducted(std::move(session));
  const TurnLimits limits(make_ball_socket_pair(800, impinging_cam()));
  const JointTurn turn = joint_turn({}, motion_name("abduction"), Side::right);
  const TurnLimit expected = limits.first_contact(turn, 180.0);
  const Json& told_limits = found.document["limits"];
  ASSERT_EQ(told_limits.size(), 3U);
  const Json& contact = told_limits[0];
  EXPECT_EQ(contact["state"], "limited");
  EXPECT_EQ(contact["centre"], "ball");
  EXPECT_NEAR(contact["low_deg"].get<double>(), expected.low_deg, 1e-9);
  EXPECT_NEAR(contact["high_deg"].get<double>(), expected.high_deg, 1e-9);
  const Vec3 place = input_to_joint("LPS").transpose() * expected.contact->place + kAt;
  EXPECT_NEAR(contact["position"][0].get<double>(), place.x(), 1e-6);
  EXPECT_NEAR(contact["position"][2].get<double>(), place.z(), 1e-6);
  const ToldLimit told = told_limit(limits, turn, 0.0, 180.0);
  EXPECT_NEAR(contact["half_mm_gap_deg"].get<double>(), *told.half_mm_gap_deg, 1e-9);
  EXPECT_LT(*told.half_mm_gap_deg, expected.low_deg);
  EXPECT_NEAR(contact["centre_low_deg"].get<double>(), told.common.low_deg, 1e-9);
  EXPECT_NEAR(contact["play_low_deg"].get<double>(), told.play.low_deg, 1e-9);
  EXPECT_NEAR(contact["centre_of_rotation"][1].get<double>(), kAt.y(), 1e-9);
  EXPECT_EQ(joint["side"], "right");
  EXPECT_EQ(joint["axes"], "LPS");
  EXPECT_EQ(joint["centre"]["position"][0], kAt.x());
  EXPECT_EQ(told_limits[2]["threshold_mm"], 2.0);
  EXPECT_NEAR(told_limits[2]["low_deg"].get<double>(), limits.gap_of(turn, 2.0, 180.0).low_deg, 1e-9);
  EXPECT_EQ(told_limits[1]["centre"], "socket");
  EXPECT_NEAR(told_limits[1]["low_deg"].get<double>(), expected.low_deg, 0.5) << "one centre, fitted";
  EXPECT_NE(found.words.find("of abduction"), std::string::npos) << found.words;
  EXPECT_NE(found.words.find("\ngap of 2 mm         between "), std::string::npos)
      << found.words;  // as wide as the others
}

TEST(LimitsCommand, SaysFreeAndBlocked) {
  const Told found = abducted(session_of({}), 5.0);  // above the joint space
  EXPECT_EQ(found.document["limits"][0]["state"], "free");
  EXPECT_EQ(found.document["limits"][0]["high_deg"], 180.0);
  EXPECT_EQ(found.document["limits"].back()["state"], "blocked");
  EXPECT_NE(found.words.find("none up to 180"), std::string::npos) << found.words;
  EXPECT_NE(found.words.find("reached at the start"), std::string::npos) << found.words;
}

// A limit that a graze makes: what is said must tell that half a millimetre changes it.
TEST(LimitsCommand, FlagsWhatHangsOnLessThanHalfAMillimetre) {
  PairShape grazing;  // the cam passes under the socket's rim less than 0.1 mm away from it
  grazing.cam_height = 3.95;
  const Told found = abducted(session_of(grazing));
  const Json& contact = found.document["limits"][0];
  EXPECT_EQ(contact["state"], "free");
  EXPECT_LT(contact["half_mm_gap_deg"].get<double>(), 60.0);
  EXPECT_TRUE(contact["hangs_on_less_than_half_mm"].get<bool>());
  EXPECT_NE(found.words.find("of play, by more than 5 degrees"), std::string::npos) << found.words;
  grazing.cam_height = 3.0;  // a whole millimetre
  const Json clear = abducted(session_of(grazing)).document["limits"][0];
  EXPECT_TRUE(clear["half_mm_gap_deg"].is_null());
  EXPECT_FALSE(clear["hangs_on_less_than_half_mm"].get<bool>());
}

// A ball that is a cap: where it ends nothing is known.
TEST(LimitsCommand, SaysWhereTheBallsMeshEnds) {
  Joint joint = scanned_joint({});
  TriangleMesh& ball = joint.ball.mesh;
  std::erase_if(ball.faces, [&](const Face& f) { return corner(ball, f, 0).z() < -6.0; });
  const Told found = abducted({std::move(joint), Side::right, "LPS"});
  const Json& contact = found.document["limits"][0];
  EXPECT_EQ(contact["state"], "unknown");
  EXPECT_EQ(contact["low_deg"], contact["leaves_ball_mesh_deg"]);
  EXPECT_NE(found.words.find("leaves the ball's mesh at "), std::string::npos) << found.words;
  EXPECT_NE(found.words.find("unknown beyond"), std::string::npos) << found.words;
}

// A limit beyond the mesh of a cap is that of the cap: no later for more of the ball, but perhaps earlier.
TEST(LimitsCommand, SaysThatWhatIsMissingMayComeFirst) {
  const char* said = "degrees on: what is missing may come first";
  Joint joint = scanned_joint(impinging_cam());
  EXPECT_EQ(abducted({joint, Side::right, "LPS"}).words.find(said), std::string::npos);
  TriangleMesh& ball = joint.ball.mesh;
  std::erase_if(ball.faces, [&](const Face& f) { return corner(ball, f, 0).z() < -8.0; });
  const Told found = abducted({std::move(joint), Side::right, "LPS"});
  const Json& cartilage = found.document["limits"].back();
  EXPECT_EQ(cartilage["state"], "limited");
  EXPECT_LT(cartilage["leaves_ball_mesh_deg"], cartilage["low_deg"]);
  EXPECT_NE(found.words.find(said), std::string::npos) << found.words;
}

// Ends of what is proven are no higher, or no lower, than they are: 53.56 is "not before 53.5".
TEST(LimitsCommand, IsToldOutward) {
  LimitsAnswer found{.centre_within_mm = 0.5, .limits = std::vector<LimitAnswer>(1)};
  ToldLimit& told = found.limits.front().told;
  TurnLimit& limit = told.limit;
  limit.state = LimitState::limited;
  limit.low_deg = 53.56789;
  limit.high_deg = 53.56791;
  told.common = {40.06, 60.04, true};
  told.play.low_deg = 41.06;
  told.half_mm_gap_deg = 42.06;
  limit.leaves_mesh_deg = 43.06;
  const std::string text = describe(found);
  for (const char* said : {"between 53.5678 and 53.5680 degrees", ": 40.0 to 60.1 degrees",
                           "none before 41.0 degrees", "0.5 mm at 42.0 degrees", "from 43.0 degrees on"})
    EXPECT_NE(text.find(said), std::string::npos) << said << " in\n" << text;
  limit.state = LimitState::unknown;
  found.limits.front().unknown_by = UnknownBy::end_of_ball;
  EXPECT_NE(describe(found).find("leaves the ball's mesh at 53.5 degrees"), std::string::npos);
  limit.leaves_mesh_deg.reset();
  found.limits.front().unknown_by = UnknownBy::graze;
  EXPECT_NE(describe(found).find("none up to 53.5 degrees; beyond, unknown since surfaces graze"),
            std::string::npos);
  found.limits.front().unknown_by = UnknownBy::opening;
  EXPECT_NE(describe(found).find("; beyond, whether one bone is inside the other hangs on"),
            std::string::npos);
  limit.state = LimitState::free;
  EXPECT_NE(describe(found).find("none up to 53.5 degrees,"), std::string::npos);
}

TEST(LimitsCommand, NamesAnOpeningAsTheReasonThatNothingIsKnown) {
  const test::TemporaryFolder folder;
  const std::string joint = test::speck_in_flask(folder.path(), 0.8);
  const Json limit = test::document_of("limits" + joint + " --motions flexion")["answer"]["limits"][0];
  EXPECT_EQ(limit["state"], "unknown");
  EXPECT_EQ(limit["low_deg"], 0.0);
  EXPECT_EQ(limit["unknown_by"], "opening");
}

TEST(LimitsCommand, TableHasBothCentresAndBothRanges) {
  LimitsAnswer found{.centre_within_mm = 0.5, .limits = std::vector<LimitAnswer>(3)};
  for (LimitAnswer& limit : found.limits) {
    limit.motion = "flexion";
    limit.centre = "ball";
    limit.told.limit.state = LimitState::limited;
    limit.told.limit.low_deg = limit.told.limit.high_deg = 120.76;
    limit.told.common = {118.26, 123.01, true};
    limit.told.play = {36.66, 123.04, true};
  }
  found.limits[0].told.half_mm_gap_deg = 36.9;
  found.limits[1].centre = "socket";
  found.limits[1].told.limit.low_deg = 117.07;
  found.limits[2].motion = "extension";
  EXPECT_EQ(describe(found),
            "limits, degrees  bone on bone  about socket  centre within 0.5 mm  play up to 0.5 mm  o'clock  "
            "what meets, and doubts\n"
            "flexion          120.7         117.0         118.2 to 123.1        36.6 to 123.1               "
            "sensitive to 0.5 mm of play\n"
            "extension        120.7                       118.2 to 123.1        36.6 to 123.1\n"
            "sensitive           means that the limit may be more than 5 degrees off\n");
}

}  // namespace
}  // namespace impinge

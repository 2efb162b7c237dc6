// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene is not asked for is not worked out, and what it is asked for stays the same, bit for bit.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"
#include "scene/question.hpp"
#include "scene/report.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

Session hip() {
  const BallSocketPair pair = make_ball_socket_pair(800, impinging_cam());
  Joint joint;
  joint.ball.mesh = pair.ball;
  joint.socket.mesh = pair.socket;
  return {std::move(joint), std::nullopt, "ALS"};
}

SceneOptions flexed(const char* angle) {
  SceneOptions options;
  options.precision_deg = 2.0;  // bounds of finer tables take a while
  options.motion = parse_motion(std::string("flexion=") + angle);
  return options;
}

void expect_same(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_TRUE(a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i]))) << "vertex " << i;
}

TEST(SceneNeeds, GapsAloneAreTheGaps) {
  Session session = hip();
  SceneOptions options = flexed("60");
  const Measurement everything = measure(session, options);
  EXPECT_TRUE(everything.left_out.empty());
  ASSERT_TRUE(everything.certificate);
  options.outputs = {true, false, false, false};
  const Measurement gaps = measure(session, options);
  expect_same(gaps.ball.gap, everything.ball.gap);
  expect_same(gaps.socket.gap, everything.socket.gap);
  EXPECT_TRUE(gaps.ball.bound.empty() && gaps.ball.distance.empty() && !gaps.certificate);
  EXPECT_EQ(gaps.entries, everything.entries) << "of the scheme";
}

TEST(SceneNeeds, AQuestionIsAnsweredAsAllGapsAnswerIt) {
  Session session = hip();
  for (const char* angle : {"0", "30", "60"}) {
    SceneOptions options = flexed(angle);
    options.outputs = {true, false, false, false};
    const Measurement gaps = measure(session, options);
    double smallest = HUGE_VAL;
    for (const double g : gaps.ball.gap) smallest = std::fmin(smallest, g);
    for (const double g : gaps.socket.gap) smallest = std::fmin(smallest, g);
    const auto of_all = summary(options, *session.joint, gaps)["smallest_gap"];
    EXPECT_EQ(of_all["gap_mm"], smallest);
    options.question = Question::first_contact;
    const QuestionAnswer contact = answer_question(*session.joint, options);
    EXPECT_EQ(contact.answer.smallest->gap_mm, smallest);
    const auto found = question_summary(options, *session.joint, contact)["smallest_gap"];
    for (const char* key : {"gap_mm", "surface", "vertex", "position"}) EXPECT_EQ(found[key], of_all[key]);
    options.question = Question::touch;
    EXPECT_EQ(answer_question(*session.joint, options).answer.touches, std::vector<bool>{smallest <= 0.0});
  }
}

// Asked for no table, a single pose is measured on the faces: gaps are those of rays, a table's are within
// its bounds of them, and the other questions answer alike.
TEST(SceneNeeds, TheFacesAnswerASinglePose) {
  Session session = hip();
  for (const char* angle : {"0", "30", "60"}) {
    SceneOptions options = flexed(angle);
    const Measurement table = measure(session, options);
    EXPECT_EQ(table.bytes, 2 * sizeof(double) * table.entries);
    options.precision_deg.reset();
    const Measurement faces = measure(session, options);
    EXPECT_EQ(faces.entries, 0U);
    EXPECT_LT(faces.proven->largest_mm, 1e-9);
    EXPECT_EQ(faces.certificate->surfaces_impinged, table.certificate->surfaces_impinged);
    EXPECT_EQ(faces.certificate->ball.impinged, table.certificate->ball.impinged);
    EXPECT_EQ(faces.certificate->ball.refuted + faces.certificate->socket.refuted, 0U);
    const RayCaster socket(session.joint->joint.socket.mesh);
    for (std::size_t i = 0; i < faces.ball.gap.size(); ++i) {
      const Vec3 x = to_socket(faces.pose, session.joint->joint.ball.mesh.vertices[i]);
      const double gap = socket.cast(x.normalized(), Layer::nearest) - x.norm();
      ASSERT_EQ(std::isnan(faces.ball.gap[i]), std::isnan(gap)) << i;
      if (std::isnan(gap)) continue;
      EXPECT_LE(std::abs(gap - faces.ball.gap[i]), faces.ball.bound[i] + 1e-11) << i;
      if (std::isnan(table.ball.gap[i])) continue;
      EXPECT_LE(std::abs(gap - table.ball.gap[i]), table.ball.bound[i] + 1e-11) << i;
    }
    options.question = Question::first_contact;
    EXPECT_EQ(answer_question(*session.joint, options).answer.smallest->gap_mm, faces.smallest->gap_mm);
    options.question = Question::touch;
    EXPECT_EQ(answer_question(*session.joint, options).answer.touches[0],
              faces.certificate->surfaces_impinged);
    options.question = Question::all_gaps;
    options.scan_socket = false;
    options.outputs = {true, false, false, false};
    const Measurement ball = measure(session, options);
    expect_same(ball.ball.gap, faces.ball.gap);
    EXPECT_TRUE(ball.socket.gap.empty() && ball.ball.bound.empty());
    EXPECT_NE(ball.way.find("measured on the faces near it"), std::string::npos) << ball.way;
  }
}

// Where edges cross and no vertex is beyond, the surfaces touch, and vertices alone would not say so.
TEST(SceneNeeds, ATouchBetweenVerticesIsOne) {
  Session session = hip();
  SceneOptions options = flexed("30");
  options.precision_deg.reset();
  options.outputs = {true, false, false, true};
  bool between = false;
  for (double angle = 30.0; angle < 60.0 && !between; angle += 0.05) {
    options.motion.flexion = angle;
    options.question = Question::all_gaps;
    const Certificate certificate = *measure(session, options).certificate;
    between = certificate.surfaces_impinged && !certificate.vertices_impinged();
  }
  ASSERT_TRUE(between);
  options.question = Question::touch;
  EXPECT_TRUE(answer_question(*session.joint, options).answer.touches[0]);
  options.scan_socket = false;
  EXPECT_FALSE(answer_question(*session.joint, options).answer.touches[0]) << "of the ball's vertices";
}

TEST(SceneNeeds, WhatIsLeftOutIsSaidWithWhatItSaves) {
  Session session = hip();
  SceneOptions options = flexed("0");
  options.question = Question::touch;
  options.precision_deg = 0.1;
  const QuestionAnswer found = answer_question(*session.joint, options);
  const std::string text = describe_way(found.way, found.answer.left_out);
  EXPECT_NE(text.find("left out"), std::string::npos);
  EXPECT_NE(text.find("saves"), std::string::npos) << text;
  EXPECT_NE(describe_way("", {}).find("left out            nothing\n"), std::string::npos);
}

// Which way, and of whole tables which of the times faster kernels could save.
TEST(SceneNeeds, TheWayIsSaid) {
  Session session = hip();
  SceneOptions options = flexed("0");
  const std::string whole = measure(session, options).way;
  EXPECT_NE(whole.find("whole tables"), std::string::npos) << whole;
  EXPECT_NE(whole.find("fill_tables and scan in times_ms"), std::string::npos) << whole;
  options.outputs = {true, false, false, false};
  const std::string part = measure(session, options).way;
  EXPECT_NE(part.find("tables of what the vertices read"), std::string::npos) << part;
  options.question = Question::touch;
  EXPECT_EQ(answer_question(*session.joint, options).way, part);
  options.precision_deg.reset();
  EXPECT_EQ(describe_way(answer_question(*session.joint, options).way, {}),
            "way                 the surfaces of all bones are compared, edges and all, by exact signs\n"
            "left out            nothing\n");
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: a limit says what of the bones meets, whichever centre the ball turns about, for contact, for a
// threshold and where all is blocked from the start. What places are called: tests/hip/joint_test.cpp.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/hip_surface.hpp"
#include "joint/limits.hpp"

namespace impinge {
namespace {

Session session_of(Hip hip, const Vec3& centre) {
  JointInput input;
  input.centre = centre;
  input.ball = {"ball", std::move(hip.ball)};
  input.socket = {"socket", std::move(hip.socket)};
  return {assemble_joint(std::move(input)), Side::right, "RAS"};
}

HipParameters right(const char* preset) {
  HipParameters parameters = hip_preset(preset);
  parameters.side = Side::right;
  return parameters;
}

TEST(LimitWords, SayThatACamMeetsTheRim) {
  Session session;
  use_hip(session, right("cam"));
  const std::vector<LimitAnswer> found = answer_limits(
      session, {.start = {.flexion = 90.0}, .growing = "internal_rotation", .cartilage_mm = 2.0});
  ASSERT_EQ(found.size(), 3U) << "about both centres, and of the cartilage";
  for (const LimitAnswer& limit : found) {
    ASSERT_EQ(limit.told.limit.state, LimitState::limited);
    EXPECT_EQ(limit.meets(), "rim and neck");
  }
}

// About a point beside the head's centre, towards which the head cannot stay: it meets the wall of the socket
// where, seen from the head, nothing but the sphere is.
TEST(LimitWords, SayThatAHeadMeetsTheSocketWithin) {
  HipParameters parameters = right("normal");
  parameters.joint_space = 1.0;
  const Vec3 centre(0.0, -8.0, 0.0);
  Session session = session_of(make_hip(parameters, 3000), centre);
  const LimitAnswer found = answer_limits(session, {.start = {}, .growing = "flexion"}).front();
  ASSERT_EQ(found.told.limit.state, LimitState::limited);
  EXPECT_EQ(found.meets(), "head within the socket");
  const HipSurface hip = hip_surface(parameters);
  const Vec3 place = found.told.limit.contact.value().place + centre - hip.socket_centre;
  EXPECT_NEAR(place.norm(), hip.socket_radius, 0.2);
  EXPECT_GT(-hip.opening.dot(place.normalized()), std::cos(0.75 * parameters.half_opening * kDegree));
}

// A threshold moves no name: the head is a layer of cartilage away from the socket.
TEST(LimitWords, NameTheBonesBehindAThreshold) {
  HipParameters parameters = right("normal");
  parameters.joint_space = 5.0;
  Session session = session_of(make_hip(parameters, 3000), Vec3(0.0, -4.0, 0.0));
  const LimitAnswer found =
      answer_limits(session, {.start = {}, .growing = "flexion", .cartilage_mm = 4.0}).back();
  ASSERT_EQ(found.told.limit.state, LimitState::limited);
  EXPECT_EQ(found.meets(), "head within the socket");
}

// The deepest place, of a head too large for its socket or of too thick a layer: towards the pole.
TEST(LimitWords, NameWhatBlocksFromTheStart) {
  const HipSurface surface = hip_surface(right("normal"));
  const Vec3 to_pole = -0.4 * surface.opening;
  Hip hip = make_hip(right("normal"), 3000);
  for (Vec3& x : hip.ball.vertices) x += to_pole;
  const Hip fitting = hip;
  for (Vec3& x : hip.ball.vertices) x *= (surface.head_radius + 7.0) / surface.head_radius;
  Session large = session_of(std::move(hip), to_pole);
  const LimitAnswer contact = answer_limits(large, {.start = {}, .growing = "flexion"}).front();
  EXPECT_EQ(contact.told.limit.state, LimitState::blocked);
  EXPECT_EQ(contact.what(), "head within the socket") << "sure for all centres";
  Session tight = session_of(fitting, to_pole);
  const auto found = answer_limits(tight, {.start = {}, .growing = "flexion", .cartilage_mm = 5.0});
  EXPECT_EQ(found.back().told.limit.state, LimitState::blocked);
  EXPECT_EQ(found.back().meets(), "head within the socket");
  EXPECT_EQ(found.front().meets(), "rim and neck");
}

TEST(LimitWords, TellOfANeckThatIsCutOff) {
  const double radius = hip_surface(right("normal")).head_radius;
  Hip hip = make_hip(right("normal"), 3000);
  const Hip whole = hip;
  std::erase_if(hip.ball.faces, [&](const Face& f) { return corner(hip.ball, f, 0).norm() > 1.5 * radius; });
  LimitsRequest flexion;
  flexion.motions = {"flexion"};
  Session cut = session_of(std::move(hip), Vec3::Zero());
  const std::optional<double> at = answer(cut, flexion).ball_cut_mm;
  ASSERT_TRUE(at);
  EXPECT_NEAR(*at, 1.5 * radius, 0.15 * radius);
  Session uncut = session_of(whole, Vec3::Zero());
  EXPECT_FALSE(answer(uncut, flexion).ball_cut_mm);
}

// Both doubts are told, each with its number.
TEST(LimitWords, HideNoDoubtBehindAnother) {
  LimitAnswer answer;
  answer.ball_part = "neck";
  answer.socket_part = "rim";
  answer.told.limit.state = LimitState::limited;
  answer.told.limit.low_deg = answer.told.limit.high_deg = 60.0;
  answer.told.limit.leaves_mesh_deg = 43.06;
  answer.told.common = {58.0, 62.0, true};
  answer.told.half_mm_gap_deg = 30.0;
  EXPECT_EQ(answer.what(), "rim and neck; sensitive to 0.5 mm of play; the ball's mesh ends from 43.0");
  answer.told.common.low_deg = 40.0;
  EXPECT_EQ(answer.told.sensitivity(), "sensitive to 0.5 mm of the centre and of play");
  answer.told.half_mm_gap_deg.reset();
  EXPECT_EQ(answer.told.sensitivity(), "sensitive to 0.5 mm of the centre");
  answer.told.limit.state = LimitState::unknown;
  answer.told.limit.low_deg = 40.0;
  answer.told.limit.leaves_mesh_deg.reset();
  answer.unknown_by = UnknownBy::opening;
  EXPECT_EQ(answer.what(), "rim and neck; hangs on an opening of a mesh");
}

// The mark is where half a millimetre moves the end by more than five degrees, whatever the end is.
TEST(LimitWords, MarkWideRanges) {
  LimitAnswer answer;
  answer.ball_part = "neck";
  answer.socket_part = "rim";
  ToldLimit& told = answer.told;
  const auto marked = [&](LimitState state, double low, const CentreInterval& range) {
    told.limit.state = state;
    told.limit.low_deg = told.limit.high_deg = low;
    told.common = range;
    const bool mark = answer.what().find("; sensitive to 0.5 mm of the centre") != std::string::npos;
    EXPECT_EQ(mark, told.hangs_on_less());
    return mark;
  };
  EXPECT_FALSE(marked(LimitState::limited, 60.0, {55.5, 64.5, true}));
  EXPECT_TRUE(marked(LimitState::limited, 60.0, {40.0, 60.0, true}));
  EXPECT_TRUE(marked(LimitState::limited, 60.0, {60.0, 140.0, true}));
  EXPECT_TRUE(marked(LimitState::limited, 60.0, {60.0, 180.0, false}));
  EXPECT_FALSE(marked(LimitState::free, 180.0, {178.0, 180.0, false}));
  EXPECT_TRUE(marked(LimitState::free, 180.0, {140.0, 180.0, false}));
  EXPECT_FALSE(marked(LimitState::blocked, 0.0, {0.0, 0.0, true}));
  EXPECT_TRUE(marked(LimitState::blocked, 0.0, {0.0, 40.0, true}));
  EXPECT_TRUE(marked(LimitState::blocked, 0.0, {0.0, 180.0, false}));
}

}  // namespace
}  // namespace impinge

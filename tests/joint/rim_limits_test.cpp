// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of the rim alone: by a closed form where head and floor of the socket overlap, and those of all bone
// where rim and neck are what meets. Which faces they are of: tests/hip/joint_test.cpp; against FCL, real
// bones too: tests/bones/limits_test.cpp.
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/named_motion.hpp"
#include "joint/limits.hpp"
#include "mesh/bodies.hpp"
#include "mesh/loft.hpp"
#include "support/hip_with_parts.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

Session rim_session(Hip hip, const Vec3& centre = Vec3::Zero()) {
  JointInput input;
  input.ball = {"ball", std::move(hip.ball), std::move(hip.ball_parts)};
  input.socket = {"socket", std::move(hip.socket), std::move(hip.socket_parts)};
  input.centre = centre;
  return {assemble_joint(std::move(input)), Side::right, "RAS"};
}

using Profile =
    std::vector<std::array<double, 2>>;  // distance from the z axis and height, mm; 0 at both ends

// About the z axis, with corners in the plane x = 0.
TriangleMesh turned_about_z(const Profile& profile) {
  constexpr int kSides = 48;
  std::vector<std::vector<Vec3>> rings;
  for (const auto& [rho, z] : profile) {
    rings.emplace_back();
    for (int k = 0; k < (rho > 0.0 ? kSides : 1); ++k) {
      const double turn = 2.0 * kPi * k / kSides;
      rings.back().emplace_back(rho * std::sin(turn), rho * std::cos(turn), z);
    }
  }
  return loft(rings);
}

void add_arc(Profile& profile, double radius, double from_deg, double to_deg) {
  const int steps = static_cast<int>(std::abs(to_deg - from_deg) / 6.0);
  for (int k = 0; k <= steps; ++k) {
    const double polar = (from_deg + (to_deg - from_deg) * k / steps) * kDegree;
    profile.push_back({radius * std::sin(polar), radius * std::cos(polar)});
  }
}

constexpr double kNeck = 9.0;  // mm, its radius

// A head with a cylinder as its neck, which looks down, in half a shell that opens downwards.
Session cylinder_neck_session(double head, double cup, double shift, const Vec3& centre = Vec3::Zero()) {
  Profile ball{{0.0, -80.0}, {kNeck, -80.0}};
  add_arc(ball, head, 180.0 - std::asin(kNeck / head) / kDegree, 2.0);
  ball.push_back({0.0, head});
  Profile shell{{0.0, cup}};
  add_arc(shell, cup, 2.0, 90.0);
  add_arc(shell, cup + 4.0, 90.0, 2.0);
  shell.push_back({0.0, cup + 4.0});
  Hip hip;
  hip.ball = turned_about_z(ball);
  hip.socket = turned_about_z(shell);
  for (Vec3& y : hip.socket.vertices) y.z() -= shift;
  return rim_session(std::move(hip), centre);
}

LimitRequest flexion(bool rim) {
  return {.start = {}, .growing = "flexion", .largest_deg = 120.0, .rim = rim};
}

// The rim is a circle about the neck axis, as far as the head's centre is from it: a turn until the neck,
// asin(c / R) wide there, has come to it.
TEST(RimLimits, HaveAClosedFormWhereHeadAndFloorOverlap) {
  for (const double shift : {1.8, 4.0}) {
    Session session = cylinder_neck_session(24.0, 26.0, shift);
    const LimitAnswer all = answer_limits(session, flexion(false)).front();
    EXPECT_EQ(all.told.limit.state, shift < 2.0 ? LimitState::limited : LimitState::blocked) << shift;
    const LimitAnswer rim = answer_limits(session, flexion(true)).front();
    ASSERT_EQ(rim.told.limit.state, LimitState::limited) << shift;
    const double expected = (std::atan2(26.0, shift) - std::asin(kNeck / std::hypot(26.0, shift))) / kDegree;
    EXPECT_NEAR(rim.told.limit.low_deg, expected, 1e-6) << shift;
    EXPECT_NEAR(rim.told.limit.high_deg, expected, 1e-6) << shift;
    EXPECT_EQ(rim.meets(), "rim and neck");
  }
}

TEST(RimLimits, HoldForEveryCentreNearby) {
  Session session = cylinder_neck_session(24.0, 26.0, 2.2);
  const CentreInterval range = answer_limits(session, flexion(true)).front().told.common;
  ASSERT_TRUE(range.limited);
  EXPECT_LT(range.high_deg - range.low_deg, 8.0);
  for (int k = 0; k < 8; ++k) {
    const Vec3 centre(0.1, 0.48 * std::cos(k * kPi / 4.0), 0.48 * std::sin(k * kPi / 4.0));
    Session other = cylinder_neck_session(24.0, 26.0, 2.2, centre);
    const TurnLimit limit = answer_limits(other, flexion(true)).front().told.limit;
    EXPECT_GE(limit.low_deg, range.low_deg) << k;
    EXPECT_LE(limit.high_deg, range.high_deg) << k;
  }
}

// All bone says the same where nothing else than the rim and the neck meets, and nothing of it is kept from
// one question to the next.
TEST(RimLimits, AreThoseOfAllBoneWhereRimAndNeckMeet) {
  int compared = 0;
  Session session = rim_session(make_hip(hip_preset("cam"), 2000));
  for (const NamedMotion& motion : named_motions()) {
    LimitRequest request{.start = motion.start, .growing = std::string(motion.growing)};
    const LimitAnswer all = answer_limits(session, request).front();
    request.rim = true;
    const LimitAnswer rim = answer_limits(session, request).front();
    request.rim = false;
    if (motion.name == "fadir") {
      EXPECT_EQ(answer_limits(session, request).front().told.limit.low_deg, all.told.limit.low_deg);
    }
    EXPECT_GE(rim.told.limit.high_deg, all.told.limit.low_deg - 1e-6);
    if (all.meets() != "rim and neck") continue;
    EXPECT_NEAR(rim.told.limit.low_deg, all.told.limit.low_deg, 1e-6) << motion.name;
    EXPECT_EQ(rim.meets(), all.meets());
    EXPECT_EQ(rim.clock(), all.clock());
    ++compared;
  }
  EXPECT_GT(compared, 7);
}

TEST(RimLimits, LeavePartsOut) {
  Session session = rim_session(make_hip(test::hip_with_parts(), 2000));
  LimitRequest request{.start = {.flexion = 70.0}, .growing = "internal_rotation"};
  const LimitAnswer all = answer_limits(session, request).front();
  ASSERT_EQ(all.socket_part, "AIIS");
  request.rim = true;
  const LimitAnswer rim = answer_limits(session, request).front();
  EXPECT_EQ(rim.socket_part, "rim");
  EXPECT_GT(rim.told.limit.low_deg, all.told.limit.high_deg);
}

// A mesh of the ball that ends in the neck says nothing of what lies beyond.
TEST(RimLimits, EndWhereTheBallsMeshDoes) {
  HipParameters parameters;
  parameters.joint_space = 10.0;
  Hip hip = make_hip(parameters, 4000);
  std::erase_if(hip.ball.faces, [&](const Face& face) { return corner(hip.ball, face, 0).norm() > 33.0; });
  Session session = rim_session(std::move(hip));
  LimitRequest request{.start = {}, .growing = "adduction"};
  const LimitAnswer all = answer_limits(session, request).front();
  ASSERT_EQ(all.told.limit.state, LimitState::unknown);
  request.rim = true;
  const LimitAnswer rim = answer_limits(session, request).front();
  EXPECT_EQ(rim.told.limit.state, LimitState::unknown);
  EXPECT_DOUBLE_EQ(rim.told.limit.leaves_mesh_deg.value(), all.told.limit.leaves_mesh_deg.value());
}

// A rim that touches the neck where a motion begins blocks it, as all bone does.
TEST(RimLimits, AreBlockedWhereTheRimTouchesFromTheStart) {
  Session session = cylinder_neck_session(24.0, 26.0, 3.0);
  LimitsRequest request;
  request.motions = {"flexion"};
  request.rim = true;
  EXPECT_FALSE(answer(session, request).rim_in_head_mm);
  const LimitAnswer turned =
      answer_limits(session, {.start = {.flexion = 75.0}, .growing = "flexion", .rim = true}).front();
  EXPECT_EQ(turned.told.limit.state, LimitState::blocked);
  EXPECT_EQ(turned.socket_part, "rim");
}

TEST(RimLimits, NeedARimAndANeck) {
  const auto refusal = [](Session session) {
    return test::thrown<std::invalid_argument>([&] { answer_limits(session, flexion(true)); });
  };
  Hip closed = make_hip({}, 2000);
  Hip head = closed;
  closed.socket = sphere(40.0, 1000);
  head.ball = sphere(24.0, 1000);
  EXPECT_EQ(refusal(rim_session(std::move(closed))),
            "rim: the socket shows no rim; give one that is open, with a ball that has a head");
  EXPECT_EQ(refusal(rim_session(std::move(head))),
            "rim: the ball has nothing but a head; give it with its neck");
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Radii know nothing of faces whose plane holds the centre, and contact counts them: on a small grid, where
// most faces are such, against CGAL's exact intersection of all faces.
#include <algorithm>
#include <array>
#include <cstddef>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "gap/overlay.hpp"
#include "limits/body_pairs.hpp"
#include "limits/turn_limit.hpp"
#include "mesh/icosphere.hpp"
#include "reference/meeting_surfaces.hpp"
#include "support/dice.hpp"
#include "support/grid_joint.hpp"
#include "support/joined.hpp"
#include "support/poses.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

bool surfaces_meet_in(const BallSocketPair& joint, const Pose& pose) {
  return surfaces_meet(test::ball_in_socket_frame(joint.ball, pose), joint.socket);
}

// In turns of the grid, where faces meet in corners and along sides too, and in any others, shifted or not.
TEST(TheoremContact, EdgeOnFacesMeetWhereCgalSays) {
  test::Dice dice(1);
  std::array<std::size_t, 2> unseen{};  // by radii: surfaces that meet; of any pose, and without a shift
  std::size_t apart = 0;
  for (std::size_t k = 0; k < random_cases() / 2; ++k) {
    const BallSocketPair joint = test::grid_joint(dice);
    const BodyPairs pairs(joint, {});
    ASSERT_FALSE(pairs.has_inside());
    const SurfaceOverlay radii(joint.ball, joint.socket);
    for (std::size_t n = 0; n < 12; ++n) {
      Pose pose{n % 2 == 0 ? test::grid_turn(dice) : dice.rotation(), Vec3::Zero()};
      if (n % 3 == 0) pose.translation = Vec3(dice.whole(-2, 2), dice.whole(-2, 2), dice.whole(-2, 2));
      const bool meet = surfaces_meet_in(joint, pose);
      const bool overlap = radii.impinged(pose);
      const BodyPairs::Verdict said = pairs.verdict(pose);
      const bool yes = said.contact == Contact::yes;
      ASSERT_EQ(yes && said.rule == ContactRule::surfaces, meet) << k << " " << n;
      ASSERT_TRUE(yes || !overlap) << k << " " << n;
      ASSERT_TRUE(overlap || !yes || said.rule != ContactRule::radii) << k << " " << n;
      if (meet && !overlap) ++unseen[pose.translation.isZero(0.0) ? 1 : 0];
      if (said.contact == Contact::no) ++apart;
    }
  }
  EXPECT_GT(std::min({unseen[0], unseen[1], apart}), random_cases() / 20);
}

// Where radii decide about the rest nothing is left of the surfaces but these faces, which are asked about
// anew: with what is left of many poses and without it the answers are the same.
TEST(BodyPairs, OfEdgeOnFacesNothingIsLeft) {
  test::Dice dice(3);
  std::array<std::size_t, 2> meet{};
  for (std::size_t k = 0; k < random_cases() / 10; ++k) {
    const BallSocketPair joint = test::grid_joint(dice);
    const BodyPairs pairs(joint, {});
    const NearPoses poses{.rotation = test::grid_turn(dice), .turn = 0.1};
    const BodyPairs::Left left = pairs.left(poses, true);
    ASSERT_EQ(left.size(), 1U);
    EXPECT_TRUE(left[0].empty());
    const bool may = pairs.may_meet(poses, true).has_value();
    EXPECT_EQ(pairs.may_meet(poses, true, left).has_value(), may) << k;
    ++meet[may ? 1 : 0];
  }
  EXPECT_GT(std::min(meet[0], meet[1]), 0U);
}

// No limit is free where the surfaces meet, from the start on.
TEST(TheoremTurn, EdgeOnFacesStopWhereCgalSays) {
  test::Dice dice(2);
  std::array<std::size_t, 4> states{};
  std::size_t unseen = 0;  // by radii: surfaces that meet at the start
  for (std::size_t k = 0; k < random_cases() / 2; ++k) {
    const BallSocketPair joint = test::grid_joint(dice);
    const JointTurn turn{.outer = k % 2 == 0 ? test::grid_turn(dice) : dice.rotation(),
                         .axis = k % 3 == 0 ? Vec3::UnitZ() : dice.direction()};
    const auto meet = [&](double degrees) {
      const Eigen::Matrix3d turned =
          Eigen::AngleAxisd(degrees * kDegree, turn.axis).toRotationMatrix() * turn.inner;
      return surfaces_meet_in(joint, {turn.outer * turned, Vec3::Zero()});
    };
    const TurnLimit limit = TurnLimits(joint).first_contact(turn, 180.0);
    ++states[static_cast<std::size_t>(limit.state)];
    const bool at_start = meet(0.0);
    ASSERT_TRUE(!at_start || limit.state == LimitState::blocked) << k;
    if (at_start &&
        !SurfaceOverlay(joint.ball, joint.socket).impinged({turn.outer * turn.inner, Vec3::Zero()}))
      ++unseen;
    for (std::size_t n = 0; n < 20 && limit.low_deg > 1e-9; ++n)
      ASSERT_FALSE(meet(dice.between(0.0, limit.low_deg - 1e-9))) << k;
    if (limit.state == LimitState::limited) {
      ASSERT_TRUE(meet(limit.high_deg)) << k;
    }
  }
  EXPECT_GT(unseen, random_cases() / 50);
  for (const LimitState state : {LimitState::limited, LimitState::free, LimitState::blocked})
    EXPECT_GT(states[static_cast<std::size_t>(state)], random_cases() / 50) << name(state);
}

// Loose triangles in planes with the centre: one that is nowhere near says nothing, one through the socket or
// inside of the ball is in contact, whichever bone it is of.
TEST(BodyPairs, LooseEdgeOnTrianglesAreAskedAboutAlone) {
  const auto with = [](TriangleMesh mesh, double from, double to) {
    test::add_face(mesh, {0, -1, from}, {0, 1, from}, {0, 0, to});
    return mesh;
  };
  const TriangleMesh ball = icosphere(20.0, 2);
  const TriangleMesh socket = cup(25.0, 80.0, 300);
  const auto said = [](const TriangleMesh& of_ball, const TriangleMesh& of_socket) {
    const BodyPairs pairs({of_ball, of_socket}, {});
    EXPECT_FALSE(pairs.has_inside());
    const BodyPairs::Verdict found = pairs.verdict({});
    EXPECT_EQ(pairs.may_meet({.turn = 1e-4}, true).has_value(), found.contact != Contact::no);
    return found;
  };
  EXPECT_EQ(said(with(ball, 21.0, 24.0), socket).contact, Contact::no);
  EXPECT_EQ(said(ball, with(socket, 21.0, 24.0)).contact, Contact::no);
  for (const auto& found : {said(with(ball, 21.0, 28.0), socket), said(ball, with(socket, 18.0, 24.0))}) {
    EXPECT_EQ(found.contact, Contact::yes);
    EXPECT_EQ(found.rule, ContactRule::surfaces);
  }
  const BodyPairs::Verdict within = said(ball, with(socket, 10.0, 15.0));
  EXPECT_EQ(within.contact, Contact::yes);
  EXPECT_EQ(within.rule, ContactRule::inside);
  EXPECT_TRUE(within.closed);
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// What half a millimetre may change of a limit: of joints whose limits have a closed form, and of given
// numbers by the words of told_limit.hpp.
#include "limits/told_limit.hpp"

#include <cmath>
#include <optional>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/icosphere.hpp"
#include "support/joined.hpp"
#include "support/turned.hpp"

namespace impinge {
namespace {

const JointTurn kBackAboutZ{.axis = -Vec3::UnitZ()};

// A corner of the ball 5 mm from the centre, a quarter turn before the middle of the wall x = 3, has the gap
// 3 / sin(a) - 5 at the angle a.
TEST(ToldLimit, OfACornerAndAWallIsAnArcsine) {
  const TriangleMesh ball{{{0, 5, 0}, {-0.5, 4.8, 0.3}, {-0.5, 4.8, -0.3}}, {{0, 1, 2}}};
  const TriangleMesh wall{{{3, -9, -9}, {3, 19, 0}, {3, -9, 9}}, {{0, 1, 2}}};
  const TurnLimits limits({ball, wall});
  const auto at_gap = [](double gap_mm) { return std::asin(3.0 / (5.0 + gap_mm)) / kDegree; };

  const ToldLimit contact = told_limit(limits, kBackAboutZ, 0.0, 90.0);
  EXPECT_EQ(contact.limit.state, LimitState::limited);
  EXPECT_NEAR(contact.limit.low_deg, at_gap(0.0), 1e-6);
  ASSERT_TRUE(contact.half_mm_gap_deg);
  EXPECT_NEAR(*contact.half_mm_gap_deg, at_gap(kErrorOfInput), 1e-6);
  EXPECT_LT(contact.common.low_deg, contact.limit.low_deg);
  EXPECT_LT(contact.play.low_deg, contact.limit.low_deg);

  const ToldLimit gap = told_limit(limits, kBackAboutZ, 1.0, 90.0);
  EXPECT_EQ(gap.threshold_mm, 1.0);
  EXPECT_NEAR(gap.limit.low_deg, at_gap(1.0), 1e-6);
  EXPECT_FALSE(gap.half_mm_gap_deg) << "of contact only";

  const ToldLimit short_of = told_limit(limits, kBackAboutZ, 0.0, 30.0);
  EXPECT_EQ(short_of.limit.state, LimitState::free);
  EXPECT_FALSE(short_of.half_mm_gap_deg) << "30 degrees are before both";
  const ToldLimit between = told_limit(limits, kBackAboutZ, 0.0, 35.0);
  EXPECT_EQ(between.limit.state, LimitState::free);
  EXPECT_TRUE(between.half_mm_gap_deg);
  EXPECT_TRUE(between.hangs_on_less());

  JointTurn through = kBackAboutZ;
  through.outer = Eigen::AngleAxisd(-40.0 * kDegree, Vec3::UnitZ()).toRotationMatrix();
  const ToldLimit blocked = told_limit(limits, through, 0.0, 30.0);
  EXPECT_EQ(blocked.limit.state, LimitState::blocked);
  EXPECT_EQ(blocked.half_mm_gap_deg, 0.0);
}

// More than five degrees earlier for some centre, or with a gap of half a millimetre so much earlier.
TEST(ToldLimit, SaysWhatALimitHangsOn) {
  const auto said = [](LimitState state, double common_low, double common_high, std::optional<double> gap) {
    ToldLimit told;
    told.limit.state = state;
    told.limit.low_deg = told.limit.high_deg = 30.0;
    told.common = {common_low, common_high, true};
    told.half_mm_gap_deg = gap;
    EXPECT_EQ(told.sensitivity().empty(), !told.hangs_on_less());
    return told.sensitivity();
  };
  constexpr LimitState kLimited = LimitState::limited;
  EXPECT_EQ(said(kLimited, 26.0, 34.0, 26.0), "");
  EXPECT_EQ(said(kLimited, 26.0, 34.0, std::nullopt), "");
  EXPECT_EQ(said(kLimited, 24.0, 34.0, 26.0), "sensitive to 0.5 mm of the centre");
  EXPECT_EQ(said(kLimited, 26.0, 36.0, 26.0), "sensitive to 0.5 mm of the centre");
  EXPECT_EQ(said(LimitState::free, 26.0, 36.0, std::nullopt), "") << "there is no end that could be later";
  EXPECT_EQ(said(kLimited, 26.0, 34.0, 24.0), "sensitive to 0.5 mm of play");
  EXPECT_EQ(said(LimitState::free, 26.0, 34.0, 29.0), "sensitive to 0.5 mm of play");
  EXPECT_EQ(said(LimitState::blocked, 24.0, 34.0, 24.0), "sensitive to 0.5 mm of the centre");
  EXPECT_EQ(said(kLimited, 24.0, 34.0, 24.0), "sensitive to 0.5 mm of the centre and of play");
}

// In other units the limit is the same, however small they are; then half a millimetre tells nothing.
TEST(ToldLimit, OfTinyUnitsIsToldWithoutOtherCentres) {
  for (const double unit : {1.0, 1e-3, 0x1p-40}) {
    BallSocketPair joint{sphere(20.0, 2000), cup(26.0, 60.0, 1000)};
    test::add_face(joint.ball, {21, -1, 0}, {21, 1, 0}, {30, 0, 1});
    for (TriangleMesh* mesh : {&joint.ball, &joint.socket}) {
      for (Vec3& x : mesh->vertices) x *= unit;
    }
    const ToldLimit told = told_limit(TurnLimits(joint), {.axis = -Vec3::UnitY()}, 0.0, 90.0);
    EXPECT_EQ(told.limit.state, LimitState::limited);
    EXPECT_NEAR(told.limit.low_deg, 28.0, 2.0) << "the rim";
    EXPECT_EQ(told.common.low_deg > 20.0, unit == 1.0) << told.common.low_deg;
    EXPECT_EQ(told.play.low_deg > 20.0, unit == 1.0) << told.play.low_deg;
    EXPECT_FALSE(unit != 1.0 && (told.common.limited || told.play.limited));
    EXPECT_TRUE(unit == 1.0 || told.hangs_on_less());
  }
}

// Two edges across each other meet where the one that turns, sqrt(442) mm from the axis, is at the height
// 20 mm of the other. All corners are farther away until the turning edge comes to the far end of that one.
TEST(ToldLimit, OfEdgesHasNoGapOfVerticesBeforeIt) {
  const TriangleMesh bar = test::turned({{{-8, 1, 21}, {8, 1, 21}, {0, 1, 10}}, {{0, 1, 2}}},
                                        std::atan2(1.0, 21.0) - 40.0 * kDegree, Vec3::UnitX());
  const TriangleMesh wall{{{0, -7, 20}, {0, 12, 20}, {6, 9, 40}}, {{0, 1, 2}}};
  const TurnLimits limits({bar, wall});
  for (const double largest : {30.0, 80.0}) {
    const ToldLimit told = told_limit(limits, {.axis = Vec3::UnitX()}, 0.0, largest);
    EXPECT_EQ(told.limit.state, LimitState::limited);
    EXPECT_NEAR(told.limit.low_deg, 40.0 - std::acos(20.0 / std::sqrt(442.0)) / kDegree, 1e-6);
    EXPECT_FALSE(told.half_mm_gap_deg);
  }
}

// Bone beside the joint stops the turn where the surfaces of the joint are 8 mm apart all the time.
TEST(ToldLimit, OfBoneBesideTheJointHasNoGapOfVerticesBeforeIt) {
  const TriangleMesh of_ball = test::moved(icosphere(5.0, 2), Vec3(40, 0, 0));
  const TriangleMesh of_socket = test::moved(icosphere(5.0, 2), Vec3(0, 40, 0));
  const TurnLimits limits({icosphere(20.0, 2), cup(28.0, 60.0, 400)}, {{of_ball}, {of_socket}});
  const ToldLimit told = told_limit(limits, {.axis = Vec3::UnitZ()}, 0.0, 120.0);
  EXPECT_EQ(told.limit.state, LimitState::limited);
  EXPECT_FALSE(told.half_mm_gap_deg);
}

// The ball's mesh has ended under a corner of the socket before: the limit is unknown, and so is a gap behind
// that end.
TEST(ToldLimit, OfAMeshThatEndsHasNoGapBehindItsEnd) {
  const TriangleMesh before{{{-5, 0.3, -0.3}, {-5, -0.3, -0.3}, {-5, 0, 0.4}}, {{0, 1, 2}}};
  const TriangleMesh over{{{-20, 0, 0}, {-20, 1, 2}, {-20, -1, 2}}, {{0, 1, 2}}};
  const TriangleMesh ball{{{0, 5, 0}, {-0.5, 4.8, 0.3}, {-0.5, 4.8, -0.3}}, {{0, 1, 2}}};
  const TriangleMesh wall{{{3, -9, -9}, {3, 19, 0}, {3, -9, 9}}, {{0, 1, 2}}};
  const TurnLimits limits({test::joined(ball, before), test::joined(wall, over)});
  const double half_mm = std::asin(3.0 / 5.5) / kDegree;
  EXPECT_NEAR(limits.gap_of(kBackAboutZ, kErrorOfInput, 35.0).low_deg, half_mm, 1e-6);
  const ToldLimit told = told_limit(limits, kBackAboutZ, 0.0, 35.0);
  EXPECT_EQ(told.limit.state, LimitState::unknown);
  EXPECT_LT(told.limit.low_deg, 4.0);
  EXPECT_FALSE(told.half_mm_gap_deg);
}

struct Told {
  LimitState state;
  double low_deg;     // of the limit, whose high end is the same
  double common_low;  // degrees
  std::optional<double> common_high;
  std::optional<double> half_mm_gap_deg;
};

bool hangs_on_less(const Told& given) {
  ToldLimit told;
  told.limit.state = given.state;
  told.limit.low_deg = given.low_deg;
  told.limit.high_deg = given.low_deg;
  told.common = {given.common_low, given.common_high.value_or(180.0), given.common_high.has_value()};
  told.half_mm_gap_deg = given.half_mm_gap_deg;
  return told.hangs_on_less();
}

TEST(ToldLimit, HangsOnHalfAMillimetreThatMovesItByMoreThanFiveDegrees) {
  const auto limited = LimitState::limited;
  EXPECT_FALSE(hangs_on_less({limited, 40.0, 36.0, 44.0, 36.0}));
  EXPECT_FALSE(hangs_on_less({limited, 40.0, 36.0, 44.0, std::nullopt}));
  EXPECT_TRUE(hangs_on_less({limited, 40.0, 36.0, 44.0, 34.0})) << "the gap is small long before";
  EXPECT_TRUE(hangs_on_less({limited, 40.0, 34.0, 44.0, 36.0})) << "some centre has contact long before";
  EXPECT_TRUE(hangs_on_less({limited, 40.0, 36.0, 46.0, 36.0})) << "some has it long after";
  EXPECT_TRUE(hangs_on_less({limited, 40.0, 36.0, std::nullopt, 36.0})) << "some may have none";

  const auto free = LimitState::free;
  EXPECT_FALSE(hangs_on_less({free, 90.0, 88.0, std::nullopt, std::nullopt}));
  EXPECT_TRUE(hangs_on_less({free, 90.0, 88.0, std::nullopt, 89.0})) << "a small gap, and no limit";
  EXPECT_TRUE(hangs_on_less({free, 90.0, 84.0, std::nullopt, std::nullopt}));
  EXPECT_FALSE(hangs_on_less({LimitState::unknown, 90.0, 88.0, std::nullopt, std::nullopt}));
  EXPECT_TRUE(hangs_on_less({LimitState::unknown, 90.0, 88.0, std::nullopt, 89.0}));

  const auto blocked = LimitState::blocked;
  EXPECT_FALSE(hangs_on_less({blocked, 0.0, 0.0, 4.0, 0.0}));
  EXPECT_TRUE(hangs_on_less({blocked, 0.0, 0.0, 6.0, 0.0})) << "some centre comes far";
  EXPECT_TRUE(hangs_on_less({blocked, 0.0, 0.0, std::nullopt, 0.0})) << "some may not be blocked at all";
}

}  // namespace
}  // namespace impinge

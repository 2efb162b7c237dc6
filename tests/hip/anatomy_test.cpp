// SPDX-License-Identifier: GPL-3.0-or-later
// Joint frame: x to the patient's right, y anterior, z superior. The foot points to -z, the knee looks to +y.
#include "hip/anatomy.hpp"

#include <cmath>
#include <random>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "hip/clock.hpp"
#include "hip/gap_levels.hpp"
#include "hip/landmarks.hpp"
#include "hip/length_unit.hpp"
#include "hip/motion.hpp"
#include "hip/named_motion.hpp"
#include "mesh/bodies.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {
namespace {

const Vec3 kFoot(0.0, 0.0, -1.0);
const Vec3 kKnee(0.0, 1.0, 0.0);

TEST(Anatomy, AxisCodes) {
  EXPECT_EQ(input_to_joint("RAS"), Eigen::Matrix3d::Identity());
  EXPECT_EQ(input_to_joint("LPS") * Vec3(1, 2, 3), Vec3(-1, -2, 3));
  EXPECT_EQ(input_to_joint("ASR") * Vec3(1, 2, 3), Vec3(3, 1, 2));
  for (const char* wrong : {"", "RA", "RASS", "RAX", "ras", "RRS", "LAS", "RLS"}) {
    EXPECT_THROW(input_to_joint(wrong), std::invalid_argument) << wrong;
  }
}

TEST(Anatomy, Sides) {
  EXPECT_EQ(parse_side("left"), Side::left);
  EXPECT_EQ(parse_side("right"), Side::right);
  EXPECT_THROW(parse_side("Left"), std::invalid_argument);
}

TEST(Motion, FlexionBringsTheFootForward) {
  for (const auto& side : {std::optional<Side>(), std::optional(Side::left), std::optional(Side::right)}) {
    EXPECT_LT((joint_rotation(parse_motion("flexion=90"), side) * kFoot - Vec3(0, 1, 0)).norm(), 1e-15);
    EXPECT_LT((joint_rotation(parse_motion("extension=90"), side) * kFoot - Vec3(0, -1, 0)).norm(), 1e-15);
  }
}

TEST(Motion, AbductionTakesTheFootAwayFromTheMidline) {
  EXPECT_GT((joint_rotation(parse_motion("abduction=30"), Side::right) * kFoot).x(), 0.49);
  EXPECT_LT((joint_rotation(parse_motion("abduction=30"), Side::left) * kFoot).x(), -0.49);
  EXPECT_LT((joint_rotation(parse_motion("adduction=30"), Side::right) * kFoot).x(), -0.49);
}

TEST(Motion, InternalRotationTurnsTheKneeToTheMidline) {
  EXPECT_LT((joint_rotation(parse_motion("internal_rotation=30"), Side::right) * kKnee).x(), -0.49);
  EXPECT_GT((joint_rotation(parse_motion("internal_rotation=30"), Side::left) * kKnee).x(), 0.49);
  EXPECT_GT((joint_rotation(parse_motion("external_rotation=30"), Side::right) * kKnee).x(), 0.49);
}

// At 90 degrees of flexion the thigh points forward; internal rotation, about the thigh, swings the shank
// outwards.
TEST(Motion, RotationIsAboutTheFlexedThigh) {
  const Eigen::Matrix3d r = joint_rotation(parse_motion("flexion=90,internal_rotation=90"), Side::right);
  EXPECT_LT((r * kFoot - Vec3(0, 1, 0)).norm(), 1e-15);
  EXPECT_LT((r * kKnee - Vec3(-1, 0, 0)).norm(), 1e-15);
  EXPECT_NEAR(r.determinant(), 1.0, 1e-15);
}

TEST(Motion, ThreeNumbersAreFlexionAbductionAndInternalRotation) {
  const Motion motion = parse_motion("90,-15,30");
  EXPECT_EQ(motion.flexion, 90.0);
  EXPECT_EQ(motion.abduction, -15.0);
  EXPECT_EQ(motion.internal_rotation, 30.0);
  for (const char* wrong : {"90", "90,0", "90,0,0,0", "90,x,0", "90,0,181"})
    EXPECT_THROW(parse_motion(wrong), std::invalid_argument) << wrong;
}

TEST(Motion, NamesMayHaveBlanks) {
  EXPECT_EQ(named_motion("internal rotation at 90").name, "internal_rotation_at_90");
  EXPECT_THROW(named_motion("internal"), std::invalid_argument);
}

TEST(Motion, RefusesWhatItCannotRead) {
  for (const char* wrong :
       {"flexion", "flexion=", "flexion=x", "flexion=90x", "flexion=nan", "flexion=181", "bend=3",
        "flexion=10,extension=5", "flexion=10,flexion=10", "=3", ",flexion=1"}) {
    EXPECT_THROW(parse_motion(wrong), std::invalid_argument) << wrong;
  }
  EXPECT_THROW(joint_rotation(parse_motion("abduction=5"), std::nullopt), std::invalid_argument);
  EXPECT_EQ(joint_rotation(parse_motion(""), std::nullopt), Eigen::Matrix3d::Identity());
}

// R(a) = outer R(axis, a) inner is the rotation of the motion with one angle grown by a.
TEST(Motion, OneAngleGrowsAboutOneAxis) {
  const Motion start = parse_motion("flexion=50,adduction=20,internal_rotation=15");
  for (const Side side : {Side::left, Side::right}) {
    for (const MotionName& growing : motion_names()) {
      const JointTurn turn = joint_turn(start, growing, side);
      Motion end = start;
      end.*growing.angle += growing.sign * 25.0;
      const Eigen::Matrix3d r = turn.outer * Eigen::AngleAxisd(25.0 * kDegree, turn.axis) * turn.inner;
      EXPECT_LT((r - joint_rotation(end, side)).norm(), 1e-14) << growing.name;
    }
  }
  EXPECT_THROW(joint_turn({}, motion_name("abduction"), std::nullopt), std::invalid_argument);
  EXPECT_NO_THROW(joint_turn({}, motion_name("extension"), std::nullopt));
  EXPECT_THROW(motion_name("bend"), std::invalid_argument);
}

TEST(Motion, NoAngleGrowsBeyondAnyAnatomy) {
  EXPECT_EQ(largest_growth({}, motion_name("extension")), 180.0);
  EXPECT_EQ(largest_growth(parse_motion("flexion=90"), motion_name("flexion")), 90.0);
  EXPECT_EQ(largest_growth(parse_motion("flexion=90"), motion_name("extension")), 270.0);
  EXPECT_THROW(largest_growth(parse_motion("extension=180"), motion_name("extension")),
               std::invalid_argument);
}

TEST(Motion, APathHasBothEndsAndNoLongerStep) {
  const auto path = motion_path(parse_motion("flexion=10"), parse_motion("flexion=45,abduction=7"), 10.0);
  ASSERT_EQ(path.size(), 5U);
  EXPECT_EQ(path.front().flexion, 10.0);
  EXPECT_EQ(path[2].flexion, 27.5);
  EXPECT_EQ(path[2].abduction, 3.5);
  EXPECT_EQ(path.back().abduction, 7.0);
  EXPECT_EQ(motion_path({}, {}, 1.0).size(), 1U);
}

// A socket that opens to the patient's right: the clock lies in the sagittal plane.
TEST(Clock, TwelveIsSuperiorAndThreeAnterior) {
  for (const double towards : {1.0, -1.0}) {
    TriangleMesh socket = cup(26.0, 80.0, 2000);
    for (Vec3& v : socket.vertices) v = Vec3(towards * v.z(), v.y(), -towards * v.x());
    const auto dial = clock_face(socket);
    ASSERT_TRUE(dial);
    EXPECT_NEAR(std::remainder(dial->hours({0.3, 0.0, 1.0}), 12.0), 0.0, 1e-3);
    EXPECT_NEAR(dial->hours({0.3, 1.0, 0.0}), 3.0, 1e-3);
    EXPECT_NEAR(dial->hours({0.3, 0.0, -1.0}), 6.0, 1e-3);
    EXPECT_NEAR(dial->hours({0.3, -1.0, 0.0}), 9.0, 1e-3);
    EXPECT_NEAR(dial->hours({0.0, 1.0, 1.0}), 1.5, 1e-3);
  }
}

TEST(Clock, AVerticalSocketHasNone) { EXPECT_FALSE(clock_face(cup(26.0, 80.0, 2000))); }

TEST(Clock, ZonesAreStretchesOfTheDial) {
  const std::vector<double> hours{1.1, 1.3, 1.6, 11.8, 0.1, 6.0};
  const std::vector<double> area{1.0, 2.0, 4.0, 8.0, 16.0, 32.0};
  const auto zones = clock_zones(hours, area);
  ASSERT_EQ(zones.size(), 3U);
  EXPECT_EQ(zones[0].area, 32.0);
  EXPECT_EQ(zones[0].from, 6.0);
  EXPECT_EQ(zones[0].to, 6.25);
  EXPECT_EQ(zones[1].from, 11.75);  // over twelve o'clock
  EXPECT_EQ(zones[1].to, 0.25);
  EXPECT_EQ(zones[1].area, 24.0);
  EXPECT_EQ(zones[2].from, 1.0);
  EXPECT_EQ(zones[2].to, 1.75);
  EXPECT_EQ(zones[2].area, 7.0);
  EXPECT_TRUE(clock_zones({}, {}).empty());
}

TEST(Clock, AFullTurnIsOneZone) {
  std::vector<double> hours;
  for (int k = 0; k < 480; ++k) hours.push_back(k / 40.0);
  const auto zones = clock_zones(hours, std::vector<double>(480, 0.5));
  ASSERT_EQ(zones.size(), 1U);
  EXPECT_DOUBLE_EQ(zones[0].area, 240.0);
  EXPECT_EQ(zones[0].from, zones[0].to);
}

TEST(Clock, Text) {
  EXPECT_EQ(clock_text(0.0), "12:00");
  EXPECT_EQ(clock_text(1.5), "1:30");
  EXPECT_EQ(clock_text(11.999), "12:00");
  EXPECT_EQ(clock_text(9.25), "9:15");
}

TEST(GapLevels, FiveColoursFromContactToNoImpingement) {
  const auto ball = gap_levels(Surface::ball, 4.0);
  ASSERT_EQ(ball.size(), 5U);
  EXPECT_EQ(gap_colour(-1.0, ball), ball[0].colour);
  EXPECT_EQ(gap_colour(0.0, ball), ball[0].colour);
  EXPECT_EQ(gap_colour(0.1, ball), ball[1].colour);
  EXPECT_EQ(gap_colour(4.0, ball), ball[3].colour);
  EXPECT_EQ(gap_colour(4.01, ball), ball[4].colour);
  EXPECT_EQ(gap_colour(kNoSurface, ball), kNoGapColour);
  EXPECT_NE(gap_levels(Surface::socket, 4.0)[4].colour, ball[4].colour);
  EXPECT_EQ(gap_levels(Surface::ball, 0.0).size(), 2U);
}

// Contract: motion_of_rotation() undoes joint_rotation(); a body and a femur that were turned come back to
// neutral.

TEST(Landmarks, AMotionComesBackFromItsRotation) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> wide(-179.0, 179.0);
  std::uniform_real_distribution<double> narrow(-89.0, 89.0);
  for (const Side side : {Side::left, Side::right}) {
    for (int k = 0; k < 1000; ++k) {
      const Motion motion{wide(random), narrow(random), wide(random)};
      const Motion found = motion_of_rotation(joint_rotation(motion, side), side);
      EXPECT_NEAR(found.flexion, motion.flexion, 1e-9);
      EXPECT_NEAR(found.abduction, motion.abduction, 1e-9);
      EXPECT_NEAR(found.internal_rotation, motion.internal_rotation, 1e-9);
    }
  }
}

// Of a person who stands straight, about the hip of that side.
Landmarks standing(Side side) {
  const double lateral = side == Side::right ? 1.0 : -1.0;
  const double middle = -85.0 * lateral;
  Landmarks marks;
  marks.asis_right = {middle + 120.0, 45.0, 80.0};
  marks.asis_left = {middle - 120.0, 45.0, 80.0};
  marks.pubic_tubercle_right = {middle + 25.0, 45.0, -15.0};
  marks.pubic_tubercle_left = {middle - 25.0, 45.0, -15.0};
  marks.epicondyle_medial = {-40.0 * lateral, 5.0, -400.0};
  marks.epicondyle_lateral = {40.0 * lateral, -5.0, -400.0};
  return marks;
}

TEST(Landmarks, FramesAreUprightOfWhoStandsStraight) {
  for (const Side side : {Side::left, Side::right}) {
    const AnatomicalFrames frames =
        anatomical_frames(standing(side), Vec3::Zero(), side, input_to_joint("RAS"));
    EXPECT_LT((frames.pelvis - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_NEAR(frames.pelvic_tilt_deg, 0.0, 1e-12);
    // The epicondyles are turned by atan(1 / 8) outwards: the lateral one lies behind.
    EXPECT_NEAR(frames.scanned->internal_rotation, -std::atan2(5.0, 40.0) / kDegree, 1e-9);
    EXPECT_NEAR(frames.scanned->flexion, 0.0, 1e-9);
  }
}

TEST(Landmarks, ATurnOfTheWholeBodyTurnsBothFrames) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> small(-25.0, 25.0);
  for (int k = 0; k < 200; ++k) {
    const Side side = k % 2 == 0 ? Side::left : Side::right;
    Eigen::Matrix3d body = Eigen::Matrix3d::Identity();
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())})
      body = Eigen::AngleAxisd(small(random) * kDegree, axis) * body;
    const Vec3 centre(small(random), small(random), 900.0);
    const Motion pose{small(random), small(random), small(random)};
    Landmarks marks = standing(side);
    marks.epicondyle_medial->y() = marks.epicondyle_lateral->y() = 0.0;
    for (auto at : {&Landmarks::epicondyle_medial, &Landmarks::epicondyle_lateral})
      marks.*at = joint_rotation(pose, side) * *(marks.*at);
    for (auto at :
         {&Landmarks::asis_right, &Landmarks::asis_left, &Landmarks::pubic_tubercle_right,
          &Landmarks::pubic_tubercle_left, &Landmarks::epicondyle_medial, &Landmarks::epicondyle_lateral})
      marks.*at = Vec3(body * *(marks.*at) + centre);
    const AnatomicalFrames frames = anatomical_frames(marks, centre, side, input_to_joint("RAS"));
    EXPECT_LT((frames.pelvis - body.transpose()).norm(), 1e-9);
    EXPECT_NEAR(frames.scanned->flexion, pose.flexion, 1e-9);
    EXPECT_NEAR(frames.scanned->abduction, pose.abduction, 1e-9);
    EXPECT_NEAR(frames.scanned->internal_rotation, pose.internal_rotation, 1e-9);
  }
}

TEST(Landmarks, WithoutEpicondylesThereIsNoFemur) {
  Landmarks marks = standing(Side::left);
  marks.epicondyle_medial.reset();
  EXPECT_THROW(anatomical_frames(marks, Vec3::Zero(), Side::left, input_to_joint("RAS")),
               std::invalid_argument);
  marks.epicondyle_lateral.reset();
  EXPECT_FALSE(anatomical_frames(marks, Vec3::Zero(), std::nullopt, input_to_joint("RAS")).femur);
}

// Contract: two reaches of which all of one is more than five times all of the other are in different units,
// and so are two whose radii differ by as much where they face each other; a ball with a radius of less than
// 5 mm or more than 50 is doubtful, and with less than 0.1 mm or more than 1000 it is wrong.

TEST(LengthUnit, ReachIsThatOfCornersOfFaces) {
  TriangleMesh mesh = octahedron(2.0);
  for (Vec3& v : mesh.vertices) v.z() += 1.0;
  mesh.vertices.emplace_back(100.0, 0.0, 0.0);  // of no face
  const Reach reach = reach_of(mesh);
  EXPECT_DOUBLE_EQ(reach.nearest, 1.0);
  EXPECT_DOUBLE_EQ(reach.farthest, 3.0);
}

TEST(LengthUnit, JointsOfOneUnitPass) {
  EXPECT_EQ(different_units({24.0, 25.0}, {25.5, 40.0}, NAN), "");
  EXPECT_EQ(different_units({20.0, 450.0}, {25.0, 40.0}, NAN), "");  // a whole femur
  EXPECT_EQ(different_units({24.0, 25.0}, {24.0, 180.0}, NAN), "");  // a whole pelvis
  EXPECT_EQ(different_units({1.0, 10.0}, {50.0, 60.0}, NAN), "");    // five times, and not more
  EXPECT_EQ(different_units({50.0, 60.0}, {1.0, 10.0}, NAN), "");
}

TEST(LengthUnit, FactorsBetweenUnitsDoNot) {
  for (const double factor : {1e-6, 1e-3, 0.1, 10.0, 1e3, 1e6}) {
    const std::string found = different_units({24.0 * factor, 25.0 * factor}, {25.5, 40.0}, NAN);
    EXPECT_NE(found.find("check that both meshes are in mm"), std::string::npos) << factor << found;
  }
}

TEST(LengthUnit, RadiiThatDifferWhereTheyFaceEachOtherDoNot) {
  const Reach femur{2.2, 45.0};
  const Reach pelvis{25.5, 180.0};
  for (const double ratio : {0.21, 1.1, 4.9}) EXPECT_EQ(different_units(femur, pelvis, ratio), "") << ratio;
  for (const double ratio : {0.1, 10.0}) EXPECT_NE(different_units(femur, pelvis, ratio), "") << ratio;
}

TEST(LengthUnit, SizesThatNoJointHasAreDoubtful) {
  for (const double radius : {5.0, 8.0, 25.0, 50.0, std::nan("")})
    EXPECT_EQ(doubtful_unit(radius), "") << radius;
  for (const double radius : {0.025, 2.5, 4.99, 50.1, 25000.0})
    EXPECT_NE(doubtful_unit(radius).find("lengths are read as mm"), std::string::npos) << radius;
  for (const double radius : {0.25, 2.5, 25.0, 250.0, std::nan("")})
    EXPECT_EQ(wrong_unit(radius), "") << radius;
  EXPECT_NE(wrong_unit(0.025).find("by 1000 if they are in metres"), std::string::npos);
  EXPECT_NE(wrong_unit(25000.0).find("by 0.001 if they are in micrometres"), std::string::npos);
}

}  // namespace
}  // namespace impinge

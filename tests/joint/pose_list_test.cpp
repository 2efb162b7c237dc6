// SPDX-License-Identifier: GPL-3.0-or-later
// Poses as files and grids have them. Angles of OpenSim's gait2392 are worked out by hand, in its own frame.
#include "joint/pose_list.hpp"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "files/file_error.hpp"
#include "support/temporary_folder.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

// A number of a pose, as its kind counts it.
double number(const PoseList& list, std::size_t row, int which) {
  for (std::size_t k = 0; k < list.width(); ++k)
    if (const PoseColumn& column = list.columns[k]; column.number == which)
      return column.sign * list.values[row * list.width() + k];
  return 0.0;
}
double flexion(const PoseList& list, std::size_t row) { return number(list, row, 0); }
double abduction(const PoseList& list, std::size_t row) { return number(list, row, 1); }
double internal_rotation(const PoseList& list, std::size_t row) { return number(list, row, 2); }

class PoseFile : public testing::Test {
 protected:
  PoseList read(const std::string& name, const std::string& bytes, std::optional<Side> side = Side::right) {
    return read_poses(folder_.write(name, bytes), side);
  }
  std::string refused(const std::string& name, const std::string& bytes,
                      std::optional<Side> side = Side::right) {
    return test::thrown<FileError>([&] { read(name, bytes, side); });
  }

  test::TemporaryFolder folder_;
};

TEST(PoseGrid, TheLastNamedChangesFirstAndEndsAreExact) {
  const PoseList grid = parse_pose_grid("flexion=0..0.3/0.1,adduction=10..-10/10,internal_rotation=7");
  ASSERT_EQ(grid.size(), 12U);
  EXPECT_EQ(abduction(grid, 0), -10.0);
  EXPECT_EQ(abduction(grid, 1), 0.0);
  EXPECT_EQ(abduction(grid, 2), 10.0);
  EXPECT_EQ(flexion(grid, 3), 0.1);
  EXPECT_EQ(flexion(grid, 9), 0.3);
  EXPECT_EQ(internal_rotation(grid, 11), 7.0);
}

TEST(PoseGrid, ShiftsVaryAsAnglesDo) {
  const PoseList grid = parse_pose_grid("flexion=0..90/90,tz=-500..500/500");
  ASSERT_EQ(grid.size(), 6U);
  EXPECT_TRUE(grid.shifts());
  EXPECT_EQ(grid.pose(2, {}).translation, Vec3(0.0, 0.0, 500.0));
  EXPECT_EQ(grid.pose(3, {}).translation, Vec3(0.0, 0.0, -500.0));
  EXPECT_LT((grid.pose(3, {}).rotation * Vec3(0.0, 0.0, -1.0) - Vec3(0.0, 1.0, 0.0)).norm(), 1e-15);
  EXPECT_EQ(parse_pose_grid("tx=-2..2/1").size(), 5U);
  EXPECT_EQ(parse_pose_grid("rot_x=0..10/5,trans_x=-2..2/1").kind, PoseKind::steps);
  EXPECT_EQ(parse_pose_grid("elevation=0..90/10").kind, PoseKind::shoulder);
}

TEST(PoseGrid, WhatIsNoGridIsRefusedInOneLine) {
  for (const auto& [given, word] : {std::pair("", "''"),
                                    {"flexion", "NAME=FIRST..LAST/STEP"},
                                    {"bend=0..1/1", "internal_rotation"},
                                    {"flexion=0..90", "no step"},
                                    {"flexion=0..90/0", "no step"},
                                    {"flexion=0..90/-1", "no step"},
                                    {"flexion=0..90/40", "whole steps"},
                                    {"flexion=0..181/1", "180"},
                                    {"tx=far", "length in mm"},
                                    {"tx=0..1/1,tx=2", "same angle or shift"},
                                    {"flexion=5,rot_x=5", "not of one kind"},
                                    {"flexion=nan", "nan"},
                                    {"flexion=0..1/1e-12", "ten million"},
                                    {"flexion=0..90/1,extension=3", "same angle"},
                                    {"flexion=0..90/1,", "''"},
                                    {"flexion=0..100/0.01,abduction=0..100/0.01", "ten million"}}) {
    const std::string text = given;
    const std::string said = test::thrown<std::invalid_argument>([&] { parse_pose_grid(text); });
    EXPECT_NE(said.find(word), said.npos) << text << ": " << said;
    EXPECT_EQ(said.find('\n'), said.npos);
  }
}

TEST_F(PoseFile, AnglesAreNamedInTheHeader) {
  const PoseList list = read("a.csv", "extension,internal_rotation\r\n-30,5\r\n\r\n10.5, -2\n");
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(flexion(list, 0), 30.0);
  EXPECT_EQ(flexion(list, 1), -10.5);
  EXPECT_EQ(internal_rotation(list, 1), -2.0);
  EXPECT_TRUE(list.needs_side());
}

TEST_F(PoseFile, MatricesAreRowByRowAndBecomeTheNearestRotation) {
  const std::string quarter = "0,-1,0,1.5,1,0,0,-2,0,0,1.00005,3";
  for (const std::string& rows :
       {quarter + "\n", quarter + ",0,0,0,1", "a,b,c,d,e,f,g,h,i,j,k,l\n" + quarter}) {
    const PoseList list = read("m.csv", rows, std::nullopt);
    ASSERT_EQ(list.size(), 1U);
    Eigen::Matrix3d expected;
    expected << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    EXPECT_LT((list.pose(0, {}).rotation - expected).norm(), 1e-15);
    EXPECT_EQ(list.pose(0, {}).translation, Vec3(1.5, -2.0, 3.0));
  }
}

// Only text without a number is a header; a row that lacks a number keeps its place.
TEST_F(PoseFile, ARowThatIsNotTrackedIsKept) {
  const std::string unit = "1,0,0,0,0,1,0,0,0,0,1,7";
  for (const char* head :
       {"", "\xEF\xBB\xBF", "a,b,c,d,e,f,g,h,i,j,k,\n", "\xEF\xBB\xBFr11,,,,,,,,,,,z\r\n"}) {
    for (const char* lost : {"", "nan,NaN,-nan,NAN,nan,nan,nan,nan,nan,nan,nan,nan\n", ",,,,,,,,,,,\n",
                             " , , , , , , , , , , ,\r\n", "1,0,0,,0,1,0,0,0,0,1,7\n"}) {
      const PoseList list = read("m.csv", std::string(head) + lost + unit + "\n" + lost + unit, std::nullopt);
      const std::size_t rows = *lost == '\0' ? 2 : 4;
      ASSERT_EQ(list.size(), rows) << head << lost;
      for (std::size_t row = 0; row < rows; ++row) {
        ASSERT_EQ(list.tracked(row), rows == 2 || row % 2 == 1) << head << lost << row;
        EXPECT_EQ(list.tracked(row), list.pose(row, {}).translation == Vec3(0.0, 0.0, 7.0));
      }
    }
  }
  const PoseList angles = read("a.csv",
                               "\xEF\xBB\xBF"
                               "flexion,abduction\n,5\n10,5\nnan,nan\n");
  ASSERT_EQ(angles.size(), 3U);
  EXPECT_FALSE(angles.tracked(0));
  EXPECT_TRUE(angles.tracked(1));
  EXPECT_FALSE(angles.tracked(2));
}

TEST_F(PoseFile, WhatIsNoListNamesItsLine) {
  const std::string unit = "1,0,0,0,0,1,0,0,0,0,1,0";
  for (const auto& [bytes, word] : {std::pair<std::string, const char*>("flexion\n", "holds no pose"),
                                    {"flexion,bend\n1,2\n", "line 1: unknown motion 'bend'"},
                                    {"flexion,extension\n1,2\n", "same angle"},
                                    {"frame,time\n1,2\n", "line 1: no column names an angle"},
                                    {"flexion\n10\nten\n", "line 3: 'ten'"},
                                    {"flexion\n10\n11,12\n", "line 3: 2 numbers below 1 names"},
                                    {"10,20\n", "line 1: 2 numbers without a header are no matrix"},
                                    {"flexion\n181\n", "line 2: an angle of flexion"},
                                    {"flexion\nnan\n", "has a number missing in every row"},
                                    {unit + "\n1,0,0,0,0,1,0,0,0,0,1,x\n", "line 2: 'x' is no number"},
                                    {"x" + unit.substr(1), "line 1: 'x' is no number"},
                                    {"flexion,qw\n1,2\n", "line 1: unknown motion 'qw'"},
                                    {"flexion,elevation\n1,2\n", "'flexion' is not of one kind with all"},
                                    {"qw,qx,qy\n1,0,0\n", "line 1: unknown motion 'qw'"},
                                    {"qw,qx,qy,qz\n0,0,0,0\n", "line 2: a quaternion of length 0 is no turn"},
                                    {"qw,qx,qy,qz\n1,1,0,0\n", "line 2: a quaternion has the length 1.41"},
                                    {"ball_qw,ball_qx,ball_qy,ball_qz\n1,0,0,0\n", "not the same columns"},
                                    {",,,,,,,,,,,\n", "has a number missing in every row"},
                                    {"a,b,c,d,e,f,g,h,i,j,k,l\n", "holds no pose"},
                                    {unit + "\n1,2\n", "line 2: 2 numbers below 12 names"},
                                    {unit + ",0,0,0,2", "0,0,0,1"},
                                    {"1,0,0,0,0,1,0,0,0,0,-1,0", "does not turn only"},
                                    {"1,0,0,0,0,1,0,0,0,0,1.001,0", "does not turn only"},
                                    {"0,0,0,0,0,0,0,0,0,0,0,0", "does not turn only"}}) {
    const std::string said = refused("bad.csv", bytes);
    EXPECT_NE(said.find(word), said.npos) << bytes << ": " << said;
    EXPECT_NE(said.find("bad.csv"), said.npos);
    EXPECT_EQ(said.find('\n'), said.npos);
  }
}

const std::string kHead = "walk\nversion=1\nnRows=1\nnColumns=8\ninDegrees=yes\n\nendheader\n";
const std::string kLabels =
    "time\tpelvis_tilt\thip_flexion_r\thip_adduction_r\thip_rotation_r\thip_flexion_l\thip_adduction_l\t"
    "hip_rotation_l\n";

// In gait2392 x is forward, y up and z right. Flexion of 90 degrees turns about z: the right thigh, (0, -1,
// 0), points forward, (1, 0, 0). Adduction of 30 about the turned x, which is then (0, 1, 0), brings it to
// (cos 30, 0, -sin 30), to the left: here, where x is right, y forward and z up, (-1/2, sqrt(3)/2, 0).
TEST_F(PoseFile, AMotionOfOpenSimTurnsAsItsHipDoes) {
  const PoseList list = read("walk.mot", kHead + kLabels + "0.5 1 90 30 0 0 0 0\n");
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list.columns[1].name, "hip_flexion_r");
  EXPECT_EQ(list.values[0], 0.5);
  const Vec3 thigh = list.pose(0, Side::right).rotation * Vec3(0.0, 0.0, -1.0);
  EXPECT_LT((thigh - Vec3(-0.5, std::sqrt(0.75), 0.0)).norm(), 1e-15);
  // On the left adduction goes to the right.
  const PoseList left = read("walk.mot", kHead + kLabels + "0 0 0 0 0 90 30 0\n", Side::left);
  const Vec3 other = left.pose(0, Side::left).rotation * Vec3(0.0, 0.0, -1.0);
  EXPECT_LT((other - Vec3(0.5, std::sqrt(0.75), 0.0)).norm(), 1e-15);
}

// Rotation of 90 degrees about the long axis: the front of the thigh, forward, turns inwards.
TEST_F(PoseFile, NamesOfOpenSimMayHeadACsv) {
  const std::string rows = "time,hip_flexion_l,hip_adduction_l,hip_rotation_l\n0.5,90,10,30\n";
  const PoseList list = read("a.csv", rows, Side::left);
  EXPECT_EQ(list.kind, PoseKind::hip);
  EXPECT_EQ(flexion(list, 0), 90.0);
  EXPECT_EQ(abduction(list, 0), -10.0);
  EXPECT_EQ(internal_rotation(list, 0), 30.0);
  EXPECT_NE(refused("a.csv", rows).find("hip_flexion_l, which is the other hip; check --side"),
            std::string::npos);
}

TEST_F(PoseFile, StatesOfOpenSimAreRadians) {
  const std::string head = "states\ninDegrees=no\nendheader\n";
  const std::string labels =
      "time /jointset/hip_r/hip_flexion_r/value /jointset/hip_r/hip_flexion_r/speed "
      "/jointset/hip_r/hip_adduction_r/value /jointset/hip_r/hip_rotation_r/value\n";
  const PoseList list = read("states.sto", head + labels + "0 0 9 0 1.5707963267948966\n");
  EXPECT_NEAR(internal_rotation(list, 0), 90.0, 1e-12);
  const Vec3 front = list.pose(0, Side::right).rotation * Vec3(0.0, 1.0, 0.0);
  EXPECT_LT((front - Vec3(-1.0, 0.0, 0.0)).norm(), 1e-15);
}

// Of another joint it does not matter.
TEST_F(PoseFile, AMotionOfOpenSimMayLackNumbers) {
  const PoseList list =
      read("walk.mot", kHead + kLabels + "0 1 nan 0 0 0 0 0\n1 nan 9 0 0 nan 0 0\n2 1 8 0 0 0 0 0\n");
  ASSERT_EQ(list.size(), 3U);
  EXPECT_FALSE(list.tracked(0));
  EXPECT_TRUE(list.tracked(1));
  EXPECT_EQ(flexion(list, 2), 8.0);
}

TEST_F(PoseFile, AMotionThatLacksSomethingSaysWhat) {
  EXPECT_NE(refused("a.mot", kHead + kLabels, std::nullopt).find("--side"), std::string::npos);
  EXPECT_NE(refused("a.mot", kHead + kLabels).find("no pose"), std::string::npos);
  EXPECT_NE(refused("a.mot", "x\nendheader\n" + kLabels).find("inDegrees=yes"), std::string::npos);
  EXPECT_NE(refused("a.mot", "x\ninDegrees=yes\n" + kLabels).find("endheader"), std::string::npos);
  EXPECT_NE(refused("a.mot", kHead + "time knee\n1 2\n").find("hip_flexion_r"), std::string::npos);
  EXPECT_NE(refused("a.mot", kHead + kLabels + "0 1 2\n").find("line 9: 3 numbers"), std::string::npos);
  const std::string turns = "x\nDataType=Quaternion\nendheader\ntime\tpelvis_imu\t";
  EXPECT_NE(refused("a.sto", turns + "tibia_r_imu\n0\t1,0,0,0\t1,0,0,0").find("femur_r_imu"),
            std::string::npos);
  EXPECT_NE(refused("a.sto", turns + "femur_r_imu\n0\t1,0,0\t1,0,0,0").find("no quaternion w,x,y,z"),
            std::string::npos);
}

}  // namespace
}  // namespace impinge

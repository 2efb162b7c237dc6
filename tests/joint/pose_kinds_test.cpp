// SPDX-License-Identifier: GPL-3.0-or-later
// What each kind of poses means, against turns about single axes that are written out here, in the axes in
// which its source states it.
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "joint/pose_list.hpp"

namespace impinge {
namespace {

using Matrix = Eigen::Matrix3d;

// A turn about x, y or z (0, 1, 2): its axis stays, the next one goes towards the one after that.
Matrix about(Eigen::Index axis, double degrees) {
  const double c = std::cos(degrees * std::numbers::pi / 180.0);
  const double s = std::sin(degrees * std::numbers::pi / 180.0);
  const Eigen::Index next = (axis + 1) % 3;
  const Eigen::Index last = (axis + 2) % 3;
  Matrix turn = Matrix::Zero();
  turn(axis, axis) = 1.0;
  turn(next, next) = turn(last, last) = c;
  turn(last, next) = s;
  turn(next, last) = -s;
  return turn;
}

// Axes X anterior, Y superior, Z right, as the ISB and OpenSim have them, to x right, y anterior, z superior:
// each vector is written with its components in another order.
Matrix in_ours(const Matrix& isb) {
  Matrix turn;
  const std::array<Eigen::Index, 3> from{2, 0, 1};
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index k = 0; k < 3; ++k)
      turn(i, k) = isb(from[static_cast<std::size_t>(i)], from[static_cast<std::size_t>(k)]);
  return turn;
}

// The quaternion w, x, y, z of a turn about an axis (unit vector).
std::array<double, 4> quaternion(const Vec3& axis, double degrees) {
  const double half = degrees * std::numbers::pi / 360.0;
  const Vec3 part = std::sin(half) * axis;
  return {std::cos(half), part.x(), part.y(), part.z()};
}

// Hamilton's product: first b, then a.
std::array<double, 4> product(const std::array<double, 4>& a, const std::array<double, 4>& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

template <class Numbers>
std::string row_of(const Numbers& numbers, const char* separator = ",") {
  std::ostringstream row;
  row.precision(17);
  bool first = true;
  for (const double x : numbers) {
    if (!first) row << separator;
    row << x;
    first = false;
  }
  return row.str();
}

PoseList csv(const std::string& text) { return parse_poses("poses.csv", text, Side::right); }

void expect_turn(const Matrix& found, const Matrix& truth) {
  EXPECT_LT((found - truth).norm(), 1e-14) << found;
}

// Wu et al. 2002: flexion about Z of the pelvis, adduction about the floating X, rotation about Y of the
// femur; on the right side adduction and internal rotation are positive.
TEST(PoseKinds, AnglesOfAHipAreOfTheOrderOfTheIsb) {
  const PoseList list = csv("flexion,adduction,internal_rotation\n50,20,-35\n");
  EXPECT_EQ(list.kind, PoseKind::hip);
  expect_turn(list.pose(0, Side::right).rotation, in_ours(about(2, 50.0) * about(0, 20.0) * about(1, -35.0)));
  expect_turn(list.pose(0, Side::left).rotation, in_ours(about(2, 50.0) * about(0, -20.0) * about(1, 35.0)));
}

// Wu et al. 2005: about Y of the scapula, X and Y of the humerus; elevation is negative there.
TEST(PoseKinds, AnglesOfAShoulderAreOfTheOrderOfTheIsb) {
  const PoseList list = csv("Plane of elevation,Elevation,Axial rotation,tx,ty,tz\n30,80,-25,1,2,3\n");
  EXPECT_EQ(list.kind, PoseKind::shoulder);
  EXPECT_TRUE(list.needs_side());
  expect_turn(list.pose(0, Side::right).rotation,
              in_ours(about(1, 30.0) * about(0, -80.0) * about(1, -25.0)));
  expect_turn(list.pose(0, Side::left).rotation, in_ours(about(1, -30.0) * about(0, 80.0) * about(1, 25.0)));
  EXPECT_EQ(list.pose(0, Side::right).translation, Vec3(1.0, 2.0, 3.0));
}

// The hanging right arm is (0, 0, -1); abduction brings it to the right, forward flexion forward.
TEST(PoseKinds, AnArmGoesWhereItsPlaneSays) {
  const Vec3 arm(0.0, 0.0, -1.0);
  const PoseList list = csv("plane_of_elevation,elevation\n0,90\n90,90\n");
  EXPECT_LT((list.pose(0, Side::right).rotation * arm - Vec3(1.0, 0.0, 0.0)).norm(), 1e-15);
  EXPECT_LT((list.pose(0, Side::left).rotation * arm - Vec3(-1.0, 0.0, 0.0)).norm(), 1e-15);
  EXPECT_LT((list.pose(1, Side::right).rotation * arm - Vec3(0.0, 1.0, 0.0)).norm(), 1e-15);
  EXPECT_LT((list.pose(1, Side::left).rotation * arm - Vec3(0.0, 1.0, 0.0)).norm(), 1e-15);
}

// BlenderROMFinder turns about z, then about the turned y, then about the turned x, and shifts along the axes
// that it has turned.
TEST(PoseKinds, StepsAreThoseOfBlenderRomFinder) {
  const PoseList list = csv("rot_x,rot_y,rot_z,trans_x,trans_y,trans_z,Valid_pose\n10,-20,40,1,-2,0.5,1\n");
  EXPECT_EQ(list.kind, PoseKind::steps);
  EXPECT_TRUE(list.from_scan());
  const Pose pose = list.pose(0, {});
  const Matrix turn = about(2, 40.0) * about(1, -20.0) * about(0, 10.0);
  expect_turn(pose.rotation, turn);
  EXPECT_LT((pose.translation - (turn.col(0) - 2.0 * turn.col(1) + 0.5 * turn.col(2))).norm(), 1e-14);
  EXPECT_EQ(list.columns.size(), 6U);  // what it said of validity is not ours
}

TEST(PoseKinds, AQuaternionHasWFirst) {
  const auto turn = quaternion(Vec3::UnitX(), 70.0);
  const PoseList still = csv("qw,qx,qy,qz\n" + row_of(turn) + "\n0.577,-0.577,-0.577,0\n");
  EXPECT_EQ(still.kind, PoseKind::centre);
  expect_turn(still.pose(0, {}).rotation, about(0, 70.0));
  EXPECT_EQ(still.pose(0, {}).translation, Vec3::Zero());
  EXPECT_TRUE(still.tracked(1));
  // In any order of columns.
  const PoseList moved =
      csv("tx,ty,tz,qz,qy,qx,qw\n1,2,3," + row_of(std::array{turn[3], turn[2], turn[1], turn[0]}));
  EXPECT_EQ(moved.kind, PoseKind::meshes);
  expect_turn(moved.pose(0, {}).rotation, about(0, 70.0));
  EXPECT_EQ(moved.pose(0, {}).translation, Vec3(1.0, 2.0, 3.0));
}

// A point of the ball is in the room where the point of the socket is that it then lies on.
TEST(PoseKinds, OfTwoBonesInARoomTheRelativePoseIsTaken) {
  const Vec3 slant = Vec3(2.0, -1.0, 2.0) / 3.0;
  const auto ball_turn = product(quaternion(slant, 130.0), quaternion(Vec3::UnitY(), 31.0));
  const auto socket_turn = product(quaternion(Vec3::UnitZ(), -77.0), quaternion(slant, 12.0));
  const Vec3 ball_shift(400.0, -250.0, 33.0);
  const Vec3 socket_shift(390.0, -260.0, 41.0);
  // x' of a quaternion, by the part of it that is a vector.
  const auto moved = [](const std::array<double, 4>& q, const Vec3& shift, const Vec3& x) {
    const Vec3 v(q[1], q[2], q[3]);
    return Vec3(x + 2.0 * v.cross(v.cross(x) + q[0] * x) + shift);
  };
  const auto matrix = [&](const std::array<double, 4>& q, const Vec3& shift) {
    std::vector<double> rows;
    for (Eigen::Index i = 0; i < 3; ++i) {
      for (Eigen::Index k = 0; k < 3; ++k) rows.push_back(moved(q, Vec3::Zero(), Vec3::Unit(k))[i]);
      rows.push_back(shift[i]);
    }
    return row_of(rows);
  };
  std::string heads;
  for (const char* bone : {"ball_", "Pelvis_"})
    for (const char* name : {"qw", "qx", "qy", "qz", "tx", "ty", "tz"})
      heads += (heads.empty() ? "" : ",") + std::string(bone) + name;
  std::string matrix_heads = "frame";
  for (const char* bone : {"femur_", "socket_"})
    for (int k = 0; k < 12; ++k) matrix_heads += "," + std::string(bone) + "m" + std::to_string(k);
  const PoseList quaternions = csv(heads + "\n" + row_of(ball_turn) + "," + row_of(ball_shift) + "," +
                                   row_of(socket_turn) + "," + row_of(socket_shift));
  const PoseList matrices = csv(matrix_heads + "\n7," + matrix(ball_turn, ball_shift) + "," +
                                matrix(socket_turn, socket_shift) + "\n8" + std::string(24, ','));
  EXPECT_EQ(matrices.size(), 2U);
  EXPECT_FALSE(matrices.tracked(1));
  EXPECT_EQ(matrices.columns[0].name, "frame");
  EXPECT_EQ(matrices.values[matrices.width()], 8.0);
  for (const PoseList* list : {&quaternions, &matrices}) {
    EXPECT_EQ(list->kind, PoseKind::meshes);
    const Pose pose = list->pose(0, {});
    for (const Vec3& x : {Vec3(0.0, 0.0, 0.0), Vec3(100.0, 7.0, -30.0), Vec3(-5.0, 60.0, 12.0)}) {
      const Vec3 there = moved(socket_turn, socket_shift, pose.rotation * x + pose.translation);
      EXPECT_LT((there - moved(ball_turn, ball_shift, x)).norm(), 1e-11);
    }
  }
}

// Both bones turn in the room, and nothing is known of where their sensors sit on them.
TEST(PoseKinds, SensorsOfOpenSenseBeginInTheNeutralPose) {
  const Vec3 slant = Vec3(2.0, -1.0, 2.0) / 3.0;
  const auto on_pelvis = quaternion(slant, 111.0);
  const auto on_femur = quaternion(Vec3::UnitX(), -64.0);
  const auto hip = product(quaternion(Vec3::UnitZ(), 60.0),
                           product(quaternion(Vec3::UnitX(), 15.0), quaternion(Vec3::UnitY(), 20.0)));
  const auto walked = product(quaternion(Vec3::UnitY(), 90.0), quaternion(slant, 8.0));  // the person turns
  const auto room = [](const std::array<double, 4>& bone, const std::array<double, 4>& sensor) {
    return row_of(product(bone, sensor));
  };
  const std::array<double, 4> none{1.0, 0.0, 0.0, 0.0};
  const Matrix truth = in_ours(about(2, 60.0) * about(0, 15.0) * about(1, 20.0));
  const std::string head = "DataRate=100\nDataType=Quaternion\nversion=3\nOpenSimVersion=4.2\nendheader\n";
  const PoseList sensors = parse_poses(
      "walk.sto",
      head + "time\ttorso_imu\tpelvis_imu\tfemur_r_imu\n" + "0\t1,0,0,0\tnan,nan,nan,nan\t1,0,0,0\n" +
          "0.1\t1,0,0,0\t" + room(none, on_pelvis) + "\t" + room(none, on_femur) + "\n0.2\t1,0,0,0\t" +
          room(walked, on_pelvis) + "\t" + room(product(walked, hip), on_femur) + "\n",
      Side::right);
  ASSERT_EQ(sensors.size(), 3U);
  EXPECT_FALSE(sensors.tracked(0));
  EXPECT_EQ(sensors.kind, PoseKind::joint);
  expect_turn(sensors.pose(1, {}).rotation, Matrix::Identity());
  expect_turn(sensors.pose(2, {}).rotation, truth);
  EXPECT_EQ(sensors.values[2 * sensors.width()], 0.2);
  const PoseList bodies = parse_poses(
      "walk.sto", head + "time\tpelvis\tfemur_r\n0\t" + row_of(walked) + "\t" + row_of(product(walked, hip)),
      Side::right);
  expect_turn(bodies.pose(0, {}).rotation, truth);
}

TEST(PoseKinds, ATableIsReadAsSpreadsheetsWriteIt) {
  for (const char* text :
       {"flexion,abduction\n10.5,5\n20,5\n",
        "\xEF\xBB\xBF"
        "Flexion,Abduction\r\n10.5,5\r\n20,5\r\n",
        "\"flexion\",\"abduction\"\n\"10.5\",5\n20,5\n", "flexion;abduction\n10,5;5\n20;5\n",
        "flexion\tabduction\n10.5\t5\n20\t5\n", "FLEXION\tABDUCTION\n10,5\t5\n20\t5\n",
        "frame,flexion,abduction\n1,10.5,5\n2,20,5\n", "Time;flexion;abduction\n;10,5;5\n0,5;20;5\n"}) {
    const PoseList list = csv(text);
    ASSERT_EQ(list.size(), 2U) << text;
    EXPECT_TRUE(list.tracked(0)) << text;  // a frame without a time is tracked
    expect_turn(list.pose(0, Side::right).rotation, in_ours(about(2, 10.5) * about(0, -5.0)));
    expect_turn(list.pose(1, Side::right).rotation, in_ours(about(2, 20.0) * about(0, -5.0)));
  }
}

}  // namespace
}  // namespace impinge

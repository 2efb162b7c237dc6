// SPDX-License-Identifier: GPL-3.0-or-later
// Many poses, held against every face and every vertex: exact overlay and ray casting. And a run that ended
// in any of its bytes goes on to the same file.
#include "support/poses.hpp"

#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "command/joint_options.hpp"
#include "files/file_bytes.hpp"
#include "gap/overlay.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/io.hpp"
#include "support/command_line.hpp"
#include "support/temporary_folder.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

const Vec3 kCentre(-86.0, 20.5, -580.25);  // the centre, frame of the input

class Poses : public testing::Test {
 protected:
  Poses() {
    PairShape shape;
    shape.cam_height = 4.4;
    BallSocketPair seen = make_ball_socket_pair(1200, shape);
    for (TriangleMesh* mesh : {&seen.ball, &seen.socket}) {
      for (Vec3& x : mesh->vertices) x += kCentre;
    }
    write_mesh(files_.ball, seen.ball);
    write_mesh(files_.socket, seen.socket);
    const Session session = load_joint(files_, {});
    joint_ = {session.joint->joint.ball.mesh, session.joint->joint.socket.mesh};
  }

  test::Ran run(const std::string& options) const {
    return test::run("poses " + files_.ball.string() + " " + files_.socket.string() +
                     " --centre=-86,20.5,-580.25 --side left --out " + out_.string() + " " + options);
  }
  // poses.csv, row by row; the head is the first.
  std::vector<std::vector<std::string>> answered(const std::string& options) {
    const test::Ran ran = run(options);
    EXPECT_EQ(ran.code, 0) << ran.log;
    log_ = ran.log;
    words_ = ran.out;
    found_ = Json::parse(read_bytes(out_ / "summary.json"))["answer"];
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(bytes());
    for (std::string line; std::getline(lines, line);) {
      std::vector<std::string> cells(1);
      for (const char c : line) c == ',' ? cells.emplace_back() : cells.back().append(1, c);
      rows.push_back(cells);
    }
    return rows;
  }
  // Poses from a file with these bytes.
  std::string of(const std::string& bytes) const {
    return "--poses " + folder_.write("poses.csv", bytes).string();
  }
  std::string bytes() const { return read_bytes(out_ / "poses.csv"); }

  test::TemporaryFolder folder_;
  const std::filesystem::path out_ = folder_.path() / "out";
  JointOptions files_{{.centre = kCentre}, folder_.path() / "ball.ply", folder_.path() / "socket.ply"};
  BallSocketPair joint_;  // as it was read, centre frame
  Json found_;            // the answer
  std::string words_;
  std::string log_;
};

// The least of all gaps, by rays through all faces.
double least_gap(const BallSocketPair& joint, const Pose& pose) {
  const RayCaster ball(joint.ball);
  const RayCaster socket(joint.socket);
  double least = INFINITY;
  for (const Vec3& v : joint.ball.vertices) {
    const Vec3 x = to_socket(pose, v);
    least = std::fmin(least, socket.cast(x.normalized(), Layer::nearest) - x.norm());
  }
  for (const Vec3& v : joint.socket.vertices) {
    const Vec3 x = to_ball(pose, v);
    least = std::fmin(least, x.norm() - ball.cast(x.normalized(), Layer::farthest));
  }
  return least;
}

TEST_F(Poses, AgreeWithEveryFaceAndEveryVertex) {
  const std::vector<Pose> poses = test::random_poses(300, 1.5, 7.0, 7);
  std::string matrices;
  for (const Pose& pose : poses) {
    const Vec3 moved = pose.translation + kCentre - pose.rotation * kCentre;
    std::ostringstream line;
    line.precision(17);
    for (Eigen::Index i = 0; i < 3; ++i) {
      for (Eigen::Index k = 0; k < 3; ++k) line << pose.rotation(i, k) << ',';
      line << moved[i] << (i < 2 ? "," : "\n");
    }
    matrices += line.str();
  }
  const auto rows = answered(of(matrices));
  ASSERT_EQ(rows.size(), poses.size() + 1);
  const SurfaceOverlay overlay(joint_.ball, joint_.socket);
  std::size_t touching = 0;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const auto& row = rows[k + 1];
    ASSERT_EQ(row[2], "yes");
    EXPECT_EQ(row[1] == "yes", overlay.impinged(poses[k])) << k;
    touching += row[1] == "yes";
    EXPECT_LT(std::stod(row[7]), 1e-9);
    EXPECT_NEAR(std::stod(row[3]), least_gap(joint_, poses[k]), std::stod(row[7]) + 1e-9) << k;
  }
  EXPECT_GT(touching, 20U);
  EXPECT_LT(touching, 280U);
  EXPECT_EQ(found_["touching"], touching);
}

TEST_F(Poses, ARowThatIsNotTrackedKeepsItsNumberAndSaysSo) {
  const auto rows = answered(of(",,,,,,,,,,,\n1,0,0,0,0,1,0,0,0,0,1,0\n"));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[1], (std::vector<std::string>{"1", "untracked", "", "", "", "", "", ""}));
  EXPECT_EQ(rows[2][0] + rows[2][1], "2no");
  EXPECT_EQ(found_["number_of_poses"], 2);
  EXPECT_EQ(found_["untracked"], 1);
  EXPECT_EQ(found_["smallest_gap"]["pose"], 2);
  EXPECT_NE(words_.find("1 without numbers: untracked"), std::string::npos);
}

// BlenderROMFinder's table comes back with its own column, 1 where nothing touches; steps are about the
// centre.
TEST_F(Poses, ATableOfBlenderRomFinderComesBackWithItsValidity) {
  const auto rows =
      answered(of("rot_x,rot_y,rot_z,trans_x,trans_y,trans_z,Valid_pose\n"
                  "0,0,0,0,0,0,0\n30,0,0,0,0,25,\n90,0,0,0,0,0,\n,0,0,0,0,0,\n"));
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[0][13], "trans_z");
  EXPECT_EQ(rows[0][14], "Valid_pose");
  EXPECT_EQ(rows[2][8], "30");
  for (std::size_t k = 1; k < 4; ++k) EXPECT_EQ(rows[k][14], rows[k][1] == "no" ? "1" : "0") << k;
  EXPECT_EQ(rows[1][1] + rows[2][1], "noyes");
  EXPECT_EQ(rows[4][1] + rows[4][14], "untracked");
  // About z, then about the turned x.
  Eigen::Matrix3d turned;
  turned << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  EXPECT_NEAR(std::stod(rows[3][3]), least_gap(joint_, {turned, Vec3::Zero()}), 1e-9);
}

// What was shown of a row beside its pose comes back, and the pose of two bones is that of the ball in the
// socket.
TEST_F(Poses, TwoBonesInARoomAndTheirFrames) {
  const auto rows =
      answered(of("Frame;Ball_qw;ball_qx;ball_qy;ball_qz;socket_qw;socket_qx;socket_qy;socket_qz\n"
                  "7;0,5;0,5;0,5;0,5;1;0;0;0\n8;1;0;0;0;0,5;-0,5;-0,5;-0,5\n9;;;;;1;0;0;0\n"));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0][8] + rows[0][9], "FrameBall_qw");
  EXPECT_EQ(rows[3][1] + rows[3][8], "untracked9");
  Eigen::Matrix3d third;  // of a turn about (1, 1, 1): x to y, y to z, z to x
  third << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  for (std::size_t k = 1; k < 3; ++k)
    EXPECT_NEAR(std::stod(rows[k][3]), least_gap(joint_, {third, Vec3::Zero()}), 1e-9) << k;
}

// A quarter of a turn of flexion about the centre c is x' = R x + c - R c. Its translation is given in
// another unit, left out, or both bones have moved in the room.
TEST_F(Poses, MatricesThatNoJointCanFollowGetALineThatSaysWhatToDo) {
  Eigen::Matrix3d turn;
  turn << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  const Vec3 right = kCentre - turn * kCentre;
  const double away = 600.0;
  for (const auto& [given, advice] :
       {std::pair<Vec3, std::string>(right, ""),
        {right + Vec3(20.0, 0.0, 0.0), ""},
        {right / 1000.0, "look like metres; give mm"},
        {right / 10.0, "look like centimetres; give mm"},
        {Vec3::Zero(),
         "turn about the origin of the frame; add the translation c - R c, c = -86.000,20.500,-580.250"},
        {right + Vec3(0.0, away, 0.0), "the inverse of the socket's times that of the ball"}}) {
    std::ostringstream row;
    row.precision(17);
    for (Eigen::Index i = 0; i < 3; ++i) {
      for (Eigen::Index k = 0; k < 3; ++k) row << turn(i, k) << ',';
      row << given[i] << (i < 2 ? "," : "\n");
    }
    answered(of("1,0,0,0,0,1,0,0,0,0,1,0\n" + row.str()));
    const std::string& said = log_;
    EXPECT_EQ(found_["doubt"].is_null(), advice.empty()) << advice;
    EXPECT_EQ(said.find("1 of 2 poses, first pose 2, move the centre of the ball as far as ") != said.npos,
              !advice.empty())
        << said;
    EXPECT_NE(said.find(advice), said.npos) << said;
  }
}

// Eleven rows of a flexion up to 1.5; then one row that is beyond pi.
TEST_F(Poses, ARecordingInRadiansIsDoubted) {
  std::string rows = "flexion,internal_rotation\n";
  for (int k = 0; k <= 10; ++k) rows += std::to_string(0.15 * k) + ",0.1\n";
  answered(of(rows));
  EXPECT_NE(log_.find("as if they were in radians"), std::string::npos) << log_;
  EXPECT_FALSE(found_["doubt"].is_null());
  answered(of(rows + "4,0\n"));
  EXPECT_TRUE(found_["doubt"].is_null()) << log_;
}

TEST_F(Poses, AGridMayShiftTheBall) {
  const auto rows = answered("--path flexion=0..60/60,tx=-1..1/1");
  ASSERT_EQ(rows.size(), 7U);
  EXPECT_EQ(rows[0][9], "tx");
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const Pose pose{joint_rotation({.flexion = std::stod(rows[k][8])}, Side::left),
                    Vec3(std::stod(rows[k][9]), 0.0, 0.0)};
    EXPECT_NEAR(std::stod(rows[k][3]), least_gap(joint_, pose), 1e-9);
  }
}

TEST_F(Poses, AnglesTurnAsInOnePose) {
  const auto rows = answered("--path flexion=0..60/30,abduction=-20..20/20");
  ASSERT_EQ(rows.size(), 10U);
  EXPECT_EQ(rows[0].back(), "abduction");
  EXPECT_EQ(rows[9][8] + rows[9][9], "6020");
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const Motion motion{.flexion = std::stod(rows[k][8]), .abduction = std::stod(rows[k][9])};
    const Pose pose{joint_rotation(motion, Side::left), Vec3::Zero()};
    EXPECT_NEAR(std::stod(rows[k][3]), least_gap(joint_, pose), 1e-9);
  }
}

// More than are answered between two writes.
TEST_F(Poses, ManyAreInTheirOrder) {
  const auto rows = answered("--path flexion=0..60/0.02 --outputs touch");
  ASSERT_EQ(rows.size(), 3002U);
  for (std::size_t k = 1; k < rows.size(); ++k) {
    ASSERT_EQ(rows[k].front(), std::to_string(k));
    ASSERT_NEAR(std::stod(rows[k].back()), 0.02 * static_cast<double>(k - 1), 1e-9);
  }
}

// Area of the vertices of a surface whose gap is `most` or less, by rays through all faces.
double area_within(const BallSocketPair& joint, const Pose& pose, Surface of, double most) {
  const TriangleMesh& mesh = of == Surface::ball ? joint.ball : joint.socket;
  const RayCaster other(of == Surface::ball ? joint.socket : joint.ball);
  const std::vector<double> areas = vertex_areas(mesh);
  double sum = 0.0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const Vec3 x = of == Surface::ball ? to_socket(pose, mesh.vertices[i]) : to_ball(pose, mesh.vertices[i]);
    const Layer layer = of == Surface::ball ? Layer::nearest : Layer::farthest;
    const double gap = (of == Surface::ball ? 1.0 : -1.0) * (other.cast(x.normalized(), layer) - x.norm());
    if (gap <= most) sum += areas[i];
  }
  return sum;
}

TEST_F(Poses, AreasAreThoseOfAllGaps) {
  const auto rows = answered(
      "--path flexion=10..90/40,internal_rotation=-30..30/15 --outputs touch,gap,areas --cartilage 3.1");
  EXPECT_EQ(rows[0][8] + rows[0][11], "bone_ball_mm2cartilage_socket_mm2");
  double bone = 0.0;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const Motion motion{.flexion = std::stod(rows[k][12]), .internal_rotation = std::stod(rows[k][13])};
    const Pose pose{joint_rotation(motion, Side::left), Vec3::Zero()};
    EXPECT_NEAR(std::stod(rows[k][8]), area_within(joint_, pose, Surface::ball, 0.0), 1e-9) << k;
    EXPECT_NEAR(std::stod(rows[k][9]), area_within(joint_, pose, Surface::socket, 0.0), 1e-9) << k;
    EXPECT_NEAR(std::stod(rows[k][10]), area_within(joint_, pose, Surface::ball, 3.1), 1e-9) << k;
    EXPECT_NEAR(std::stod(rows[k][11]), area_within(joint_, pose, Surface::socket, 3.1), 1e-9) << k;
    bone += std::stod(rows[k][8]);
  }
  EXPECT_GT(bone, 1.0);
}

TEST_F(Poses, WhatIsNotAskedForIsLeftOut) {
  EXPECT_EQ(answered("--path flexion=0..10/5 --outputs touch")[1][3], "");
  EXPECT_TRUE(found_["smallest_gap"].is_null());
  EXPECT_EQ(answered("--path flexion=0..10/5 --outputs gap")[1][1], "");
  EXPECT_TRUE(found_["touching"].is_null());
}

TEST_F(Poses, ARunThatEndedAnywhereGoesOnToTheSameBytes) {
  const std::string path = "--path flexion=0..150/30,internal_rotation=-20..20/20";
  answered(path);
  const std::string whole = bytes();
  const Json told = found_["smallest_gap"];
  std::filesystem::path part;
  {  // its name, from a run that cannot end
    std::filesystem::remove(out_ / "poses.csv");
    std::filesystem::create_directory(out_ / "poses.csv");
    EXPECT_EQ(run(path).code, 1);
    std::filesystem::remove(out_ / "poses.csv");
    for (const auto& file : std::filesystem::directory_iterator(out_)) {
      if (file.path().extension() == ".part") part = file.path();
    }
  }
  ASSERT_FALSE(part.empty());
  EXPECT_EQ(read_bytes(part), whole);  // nothing was lost
  for (std::size_t end = 0; end <= whole.size(); end += 37) {
    folder_.write("out" / part.filename(), whole.substr(0, end));
    answered(path);
    EXPECT_EQ(bytes(), whole) << end;
    EXPECT_EQ(found_["smallest_gap"], told);
    EXPECT_FALSE(std::filesystem::exists(part));
  }
  EXPECT_NE(log_.find("answered before"), std::string::npos);
  // Another question has a part of its own.
  folder_.write("out" / part.filename(), whole.substr(0, 200));
  EXPECT_EQ(answered("--path flexion=0..150/30,internal_rotation=-20..20/10").size(), 31U);
  EXPECT_TRUE(std::filesystem::exists(part));
}

}  // namespace
}  // namespace impinge

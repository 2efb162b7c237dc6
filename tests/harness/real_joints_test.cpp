// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/real_joints.hpp"

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "files/file_bytes.hpp"
#include "harness/contact_poses.hpp"
#include "harness/ply_series.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/io.hpp"
#include "support/temporary_folder.hpp"
#include "support/thrown.hpp"

namespace impinge::lab {
namespace {

using test::TemporaryFolder;
namespace fs = std::filesystem;

const Vec3 kCentre{100.0, -50.0, 25.0};

// A folder of a subject as a user brings it: the generated pair about kCentre.
void bring(const fs::path& folder, const std::string& ball, const std::string& socket,
           const std::string& json) {
  fs::create_directories(folder);
  const BallSocketPair pair = make_ball_socket_pair(100);
  write_mesh(folder / ball, relative_to(pair.ball, -kCentre));
  write_mesh(folder / socket, relative_to(pair.socket, -kCentre));
  std::ofstream(folder / "subject.json") << json;
}

constexpr const char* kSubject = R"({"center_of_rotation_mm": [100, -50.0, 25]})";

TEST(RealJoints, AreReadInOrderAndMovedToTheirCentre) {
  const TemporaryFolder folder;
  bring(folder.path() / "b_hip", "femoral_head.ply", "acetabulum_facing.ply", kSubject);
  bring(folder.path() / "a_shoulder", "humeral_head.ply", "glenoid_facing.ply", kSubject);
  folder.write("README.md", "no joint");
  Progress progress("test", nullptr);
  const auto joints = read_real_joints(folder.path(), progress);
  ASSERT_EQ(joints.size(), 2U);
  EXPECT_EQ(joints[0].subject, "a_shoulder");
  EXPECT_EQ(joints[1].subject, "b_hip");
  EXPECT_EQ(joints[1].centre, kCentre);
  const BallSocketPair expected = make_ball_socket_pair(100);
  ASSERT_EQ(joints[1].meshes.ball.vertices.size(), expected.ball.vertices.size());
  for (std::size_t i = 0; i < expected.ball.vertices.size(); ++i) {
    EXPECT_LT((joints[1].meshes.ball.vertices[i] - expected.ball.vertices[i]).norm(),
              2e-5);  // float32 of 125 mm
  }
}

// "side" and "axes" of the description put the meshes into the joint frame; without them it is RAS.
TEST(RealJoints, SideAndAxesAreRead) {
  const TemporaryFolder folder;
  const std::string start = R"({"center_of_rotation_mm": [100, -50.0, 25], "side": "left", "axes": ")";
  bring(folder.path() / "a", "ball.ply", "socket.ply",
        start + R"(+x = patient left, +y = posterior, +z = superior"})");
  bring(folder.path() / "b", "ball.ply", "socket.ply", kSubject);
  Progress progress("test", nullptr);
  const auto joints = read_real_joints(folder.path(), progress);
  ASSERT_EQ(joints.size(), 2U);
  EXPECT_EQ(joints[0].side, Side::left);
  EXPECT_EQ(joints[0].axes, "LPS");
  EXPECT_FALSE(joints[1].side);
  EXPECT_EQ(joints[1].axes, "RAS");
  const Vec3 x = joints[0].meshes.socket.vertices[3];
  EXPECT_EQ(in_joint_frame(joints[0]).socket.vertices[3], Vec3(-x.x(), -x.y(), x.z()));
  bring(folder.path() / "c", "ball.ply", "socket.ply", start + R"(+x = left, +y = right, +z = superior"})");
  std::ostringstream out;
  Progress told("test", &out);
  EXPECT_EQ(read_real_joints(folder.path(), told).size(), 2U);
  EXPECT_NE(out.str().find("c/subject.json: axis code"), std::string::npos) << out.str();
}

TEST(RealJoints, AFolderThatLacksAMeshIsLeftOutAndNamed) {
  const TemporaryFolder folder;
  bring(folder.path() / "good", "femoral_head.ply", "acetabulum_facing.ply", kSubject);
  bring(folder.path() / "no_socket", "femoral_head.ply", "other.ply", kSubject);
  std::ostringstream out;
  Progress progress("test", &out);
  EXPECT_EQ(read_real_joints(folder.path(), progress).size(), 1U);
  EXPECT_NE(out.str().find("no_socket has no socket mesh"), std::string::npos) << out.str();
}

// The axes that a header says, unless the description does; both must agree.
TEST(RealJoints, HeadersSayTheAxes) {
  const TemporaryFolder folder;
  bring(folder.path() / "a", "ball.obj", "socket.ply", kSubject);
  const fs::path ball = folder.path() / "a/ball.obj";
  write_bytes(ball, "# SPACE=LPS\n" + read_bytes(ball));
  Progress progress("test", nullptr);
  EXPECT_EQ(read_real_joints(folder.path(), progress)[0].axes, "LPS");
  std::ofstream(folder.path() / "a/subject.json")
      << R"({"center_of_rotation_mm": [100, -50.0, 25], "axes": "RAS"})";
  const auto said = test::thrown<std::runtime_error>([&] { read_real_joints(folder.path(), progress); });
  EXPECT_NE(said.find("its header says SPACE=LPS, and \"axes\" says RAS"), said.npos) << said;
}

// Any format, what faces the other bone before the whole of it, and without a description the centre of the
// fitted ball.
TEST(RealJoints, WhatFacesCountsAndACentreIsFitted) {
  const TemporaryFolder folder;
  const fs::path joint = folder.path() / "mine";
  bring(joint, "ball.stl", "glenoid.off", kSubject);
  write_mesh(joint / "glenoid_facing.obj", relative_to(make_ball_socket_pair(60).socket, -kCentre));
  fs::remove(joint / "subject.json");
  Progress progress("test", nullptr);
  const auto joints = read_real_joints(folder.path(), progress);
  ASSERT_EQ(joints.size(), 1U);
  EXPECT_EQ(joints[0].meshes.ball.faces.size(), 100U);
  EXPECT_EQ(joints[0].meshes.socket.faces.size(), 60U);
  Vec3 middle = Vec3::Zero();
  for (const Vec3& v : joints[0].meshes.ball.vertices) middle += v;
  EXPECT_LT(middle.norm() / static_cast<double>(joints[0].meshes.ball.vertices.size()), 1.0);
}

TEST(RealJoints, ABadDescriptionAloneIsAnErrorThatNamesTheFile) {
  for (const char* json :
       {"", "{", "[]", "{}", R"({"center_of_rotation_mm": [1, 2]})", R"({"center_of_rotation_mm": 5})",
        R"({"center_of_rotation_mm": "abc"})", R"({"center_of_rotation_mm": [1, 2, "x"]})",
        R"({"center_of_rotation_mm": {"x": 1, "y": 2, "z": 3}})"}) {
    const TemporaryFolder folder;
    bring(folder.path() / "bad", "femoral_head.ply", "acetabulum_facing.ply", json);
    Progress progress("test", nullptr);
    const auto said = test::thrown<std::runtime_error>([&] { read_real_joints(folder.path(), progress); });
    EXPECT_NE(said.find("bad/subject.json"), std::string::npos) << json << ": " << said;
  }
}

TEST(RealJoints, AFolderWithoutAnyJointIsAnError) {
  const TemporaryFolder folder;
  Progress progress("test", nullptr);
  EXPECT_THROW(read_real_joints(folder.path(), progress), std::runtime_error);
}

// Poses close to contact, on either side of it.

// Spheres of radius 20 in 26 with a common centre touch once the ball has moved by 6 mm, less the sagittas of
// their faces.
TEST(ContactPoses, FindTheFirstContact) {
  const SurfaceOverlay spheres(sphere(20.0, 4000), sphere(26.0, 4000));
  const auto impinged = [&spheres](const Pose& pose) { return spheres.impinged(pose); };
  PosePath path;
  path.shift = Vec3(0.0, 8.0, 6.0);
  const auto contact = first_contact(path, impinged);
  ASSERT_TRUE(contact);
  EXPECT_NEAR(*contact * 10.0, 6.0, 0.06);
  EXPECT_TRUE(spheres.impinged(path.at(*contact)));
  EXPECT_FALSE(spheres.impinged(path.at(*contact - 0x1p-23)));
  path.shift *= 0.5;
  EXPECT_FALSE(first_contact(path, impinged));
}

TEST(ContactPoses, AreMostlyCloseToContactAndOnBothSides) {
  const BallSocketPair joint = make_ball_socket_pair(100, impinging_cam());
  const SurfaceOverlay overlay(joint.ball, joint.socket);
  const auto poses = contact_poses(overlay, {240, 1.0, 12.0, 3});
  std::size_t close = 0;
  std::size_t impinged = 0;
  std::size_t turns = 0;
  for (const ContactPose& pose : poses) {
    impinged += overlay.impinged(pose.pose) ? 1U : 0U;
    turns += pose.path.shift.isZero() ? 1U : 0U;
    if (!pose.contact) continue;
    const Pose touching = pose.path.at(*pose.contact);
    const double way = (touching.translation - pose.pose.translation).norm() +
                       kArm * (touching.rotation - pose.pose.rotation).norm();
    close += way < 0.5 ? 1U : 0U;
  }
  EXPECT_GT(close, 75U);
  EXPECT_GT(impinged, 45U);
  EXPECT_LT(impinged, 195U);
  EXPECT_GT(turns, 0U);
}

// Contract: x y z and the states of each vertex as float32, bit for bit, behind the header below.

using test::TemporaryFolder;

const TriangleMesh kTriangle{{{0.5, -2.0, 4.0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};

TEST(PlySeries, HoldsEveryStateOfEveryVertexInTheirOrder) {
  const TemporaryFolder folder;
  const float none = std::numeric_limits<float>::quiet_NaN();
  write_ply_series(folder.path() / "a.ply", kTriangle,
                   std::vector<VertexSeries>{{"gap_0", {1.0F, 2.0F, 3.0F}}, {"gap_1", {-1.5F, none, 0.25F}}});
  std::ostringstream text;
  text << std::ifstream(folder.path() / "a.ply", std::ios::binary).rdbuf();
  const std::string bytes = text.str();
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment lengths in millimetres\nelement vertex 3\n"
      "property float x\nproperty float y\nproperty float z\nproperty float gap_0\nproperty float gap_1\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  ASSERT_EQ(bytes.substr(0, header.size()), header);
  ASSERT_EQ(bytes.size(), header.size() + 3 * 5 * 4 + 13);
  float first[5];
  float second[5];
  std::memcpy(first, bytes.data() + header.size(), sizeof first);
  std::memcpy(second, bytes.data() + header.size() + sizeof first, sizeof second);
  EXPECT_EQ(first[0], 0.5F);
  EXPECT_EQ(first[2], 4.0F);
  EXPECT_EQ(first[3], 1.0F);
  EXPECT_EQ(first[4], -1.5F);
  EXPECT_EQ(second[3], 2.0F);
  EXPECT_TRUE(std::isnan(second[4]));
}

TEST(PlySeries, IsAMeshForEveryReader) {
  const TemporaryFolder folder;
  write_ply_series(folder.path() / "a.ply", kTriangle, std::vector<VertexSeries>{{"gap_0", {1, 2, 3}}});
  const TriangleMesh read = read_mesh(folder.path() / "a.ply");
  EXPECT_EQ(read.vertices, kTriangle.vertices);
  EXPECT_EQ(read.faces, kTriangle.faces);
}

TEST(PlySeries, RefusesStatesThatDoNotFit) {
  const TemporaryFolder folder;
  const auto refused = [&](std::vector<VertexSeries> states) {
    EXPECT_THROW(write_ply_series(folder.path() / "a.ply", kTriangle, states), std::invalid_argument);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.ply"));
  };
  refused({{"gap_0", {1, 2}}});
  refused({{"", {1, 2, 3}}});
  refused({{"gap 0", {1, 2, 3}}});
  refused({{"x", {1, 2, 3}}});
  refused({{"gap_0", {1, 2, 3}}, {"gap_0", {1, 2, 3}}});
}

}  // namespace
}  // namespace impinge::lab

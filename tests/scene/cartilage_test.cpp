// SPDX-License-Identifier: GPL-3.0-or-later
// Cartilage by place: what a file may hold, and what a scene makes of it. Contract: a map that is as thick
// everywhere gives the areas, zones and colours of that one thickness.
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "files/file_bytes.hpp"
#include "files/file_error.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "joint/cartilage_file.hpp"
#include "mesh/io.hpp"
#include "scene/report.hpp"
#include "support/scene_run.hpp"
#include "support/temporary_folder.hpp"
#include "support/thrown.hpp"
#include "support/turned.hpp"

namespace impinge {
namespace {

class Cartilage : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& bytes) {
    auto path = folder_.path() / "thickness.csv";
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }

  // Head and neck alone, and gaps alone.
  SceneOptions hip(HipParameters parameters) {
    parameters.shaft_length = 0.0;
    const Hip made = make_hip(parameters, 2000);
    SceneOptions options;
    options.ball = folder_.path() / "ball.ply";
    options.socket = folder_.path() / "socket.ply";
    options.out = folder_.path() / "out";
    options.side = parameters.side;
    options.precision_deg = 1.0;
    options.outputs = {true, false, false, false};
    write_mesh(options.ball, made.ball);
    write_mesh(options.socket, made.socket);
    return options;
  }

  test::TemporaryFolder folder_;
};

TEST_F(Cartilage, PointsAreDirectionsFromTheCentre) {
  const CartilageMap map =
      read_cartilage(file("x,y,z,thickness_mm\n1,2,13,1.5\r\n1,2,-7,0\n"), Vec3(1.0, 2.0, 3.0));
  ASSERT_EQ(map.directions.size(), 2U);
  EXPECT_EQ(map.directions[0], Vec3(0, 0, 1));
  EXPECT_EQ(map.directions[1], Vec3(0, 0, -1));
  EXPECT_EQ(map.thickness, (std::vector<double>{1.5, 0.0}));
}

TEST_F(Cartilage, WhatIsNoMapIsRefusedWithItsLine) {
  const struct {
    const char* bytes;
    const char* reason;
  } cases[] = {{"1,2,3,4\n", "line 1 is not the header"},
               {"x,y,z,thickness_mm\n", "holds no point"},
               {"x,y,z,thickness_mm\n1,2,3\n", "line 2 is not four numbers"},
               {"x,y,z,thickness_mm\n1,2,3,4,5\n", "line 2 is not four numbers"},
               {"x,y,z,thickness_mm\n1,2,3,4\n1,2,3,thick\n", "line 3 is not four numbers"},
               {"x,y,z,thickness_mm\n1,2,3,nan\n", "line 2 is not four numbers"},
               {"x,y,z,thickness_mm\n1,2,3,-1\n", "line 2 has a negative thickness"},
               {"x,y,z,thickness_mm\n0,0,0,1\n", "line 2 is a point at the centre"}};
  for (const auto& wrong : cases) {
    const std::string message =
        test::thrown<FileError>([&] { read_cartilage(file(wrong.bytes), Vec3::Zero()); });
    EXPECT_NE(message.find("thickness.csv"), std::string::npos) << message;
    EXPECT_NE(message.find(wrong.reason), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_THROW(read_cartilage(folder_.path() / "none.csv", Vec3::Zero()), FileError);
}

TEST_F(Cartilage, AnEvenMapIsOneThickness) {
  SceneOptions options = hip(hip_preset("patient_a"));
  options.motion = parse_motion("abduction=48.7");
  options.cartilage_mm = 3.0;
  const auto uniform = test::run_scene(options);
  const std::string ball = read_bytes(options.out / "ball.ply");
  const std::string gaps = read_bytes(options.out / "gaps.csv");
  options.cartilage_map = file("x,y,z,thickness_mm\n9,0,0,3\n-9,0,0,3\n0,9,0,3\n");
  const auto map = test::run_scene(options);
  EXPECT_TRUE(map["cartilage_mm"].is_null());
  EXPECT_EQ(map["cartilage_map"]["points"], 3);
  for (const char* surface : {"ball", "socket"}) {
    EXPECT_GT(uniform["impingement"][1][surface]["area_mm2"], 0.0);
    EXPECT_EQ(map["impingement"][1][surface], uniform["impingement"][1][surface]);
    EXPECT_EQ(map["impingement"][0][surface], uniform["impingement"][0][surface]);
  }
  EXPECT_EQ(read_bytes(options.out / "ball.ply"), ball);
  EXPECT_EQ(read_bytes(options.out / "gaps.csv"), gaps);
}

// A map of two points, 8 mm in front and none behind, is 4 (1 + u.y) mm thick along u: a gap of 3 mm is
// within the cartilage where u.y >= -1/4.
TEST_F(Cartilage, AMapTouchesWhereItIsThickerThanTheGap) {
  SceneOptions options = hip({.joint_space = 3.0, .fossa_depth = 0.0});
  options.cartilage_map = file("x,y,z,thickness_mm\n0,9,0,8\n0,-9,0,0\n");
  const auto report = test::run_scene(options);
  const TriangleMesh socket = read_mesh(options.socket);
  const std::vector<double> area = vertex_areas(socket);
  double expected = 0.0;
  for (std::size_t i = 0; i < area.size(); ++i)
    expected += socket.vertices[i].normalized().y() >= -0.25 ? area[i] : 0.0;
  EXPECT_NEAR(report["impingement"][1]["socket"]["area_mm2"], expected, 0.05 * expected);
  EXPECT_EQ(report["impingement"][0]["socket"]["area_mm2"], 0.0);
}

// The histogram holds the area of the surface; a joint space of 3 mm fills the bin from 3 mm, or that before
// it where the table falls short of the mesh.
TEST_F(Cartilage, GapsOfAHipAreInTheHistogram) {
  const auto report = test::run_scene(hip({.joint_space = 3.05, .fossa_depth = 0.0}));
  const auto& histogram = report["gap_histogram"];
  EXPECT_EQ(histogram["first_mm"], -5.0);
  const auto& socket = histogram["socket"];
  double total = 0.0;
  for (const double x : socket["area_mm2"]) total += x;
  EXPECT_GT(socket["area_mm2"][16], 0.95 * total);
  EXPECT_EQ(socket["without_gap_mm2"], 0.0);
}

// A ball that is too large for its socket is not taken for it.
TEST_F(Cartilage, ABallThatPenetratesAllOverIsAnAnswer) {
  SceneOptions options = hip({.joint_space = 1.0});
  TriangleMesh ball = read_mesh(options.ball);
  for (Vec3& v : ball.vertices) v *= 1.1;
  write_mesh(options.ball, ball);
  EXPECT_LT(test::run_scene(options)["smallest_gap"]["gap_mm"], -1.0);
}

TEST_F(Cartilage, BonesThatOverlapAsScannedAreWarnedOf) {
  const SceneOptions sound = hip({.joint_space = 2.0});
  EXPECT_EQ(test::run_scene(sound)["warnings"].dump().find("touch as scanned"), std::string::npos);
  SceneOptions options = sound;
  options.centre = Vec3::Zero();
  write_mesh(options.ball, test::moved(read_mesh(options.ball), {-3.0, 0.0, 0.0}));
  EXPECT_NE(test::run_scene(options)["warnings"].dump().find("touch as scanned"), std::string::npos);
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Cartilage by place: what a file may hold, and what an answer makes of it. Contract: a map that is as thick
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
#include "support/command_line.hpp"
#include "support/temporary_folder.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

class Cartilage : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& bytes) {
    auto path = folder_.path() / "thickness.csv";
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }

  // Asks for gaps alone, of head and neck alone.
  std::string hip(HipParameters parameters) {
    parameters.shaft_length = 0.0;
    const Hip made = make_hip(parameters, 2000);
    write_mesh(ball_, made.ball);
    write_mesh(socket_, made.socket);
    return "gaps " + ball_.string() + " " + socket_.string() + " --side " +
           std::string(word_of(parameters.side)) + " --precision 1 --outputs gaps --out " + out_.string();
  }

  test::TemporaryFolder folder_;
  const std::filesystem::path ball_ = folder_.path() / "ball.ply";
  const std::filesystem::path socket_ = folder_.path() / "socket.ply";
  const std::filesystem::path out_ = folder_.path() / "out";
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
  const std::string line = hip(hip_preset("patient_a")) + " --pose abduction=48.7 --cartilage ";
  const Json uniform = test::document_of(line + "3")["answer"];
  const std::string ball = read_bytes(out_ / "ball.ply");
  const std::string gaps = read_bytes(out_ / "gaps.csv");
  const std::filesystem::path even = file("x,y,z,thickness_mm\n9,0,0,3\n-9,0,0,3\n0,9,0,3\n");
  const Json document = test::document_of(line + even.string());
  const Json& map = document["answer"];
  EXPECT_EQ(document["joint"]["cartilage_map"]["points"], 3);
  EXPECT_TRUE(map["impingement"][1]["gap_up_to_mm"].is_null());
  for (const char* surface : {"ball", "socket"}) {
    EXPECT_GT(uniform["impingement"][1][surface]["area_mm2"], 0.0);
    EXPECT_EQ(map["impingement"][1][surface], uniform["impingement"][1][surface]);
    EXPECT_EQ(map["impingement"][0][surface], uniform["impingement"][0][surface]);
  }
  EXPECT_EQ(read_bytes(out_ / "ball.ply"), ball);
  EXPECT_EQ(read_bytes(out_ / "gaps.csv"), gaps);
}

// A map of two points, 8 mm in front and none behind, is 4 (1 + u.y) mm thick along u: a gap of 3 mm is
// within the cartilage where u.y >= -1/4.
TEST_F(Cartilage, AMapTouchesWhereItIsThickerThanTheGap) {
  const std::string line = hip({.joint_space = 3.0, .fossa_depth = 0.0});
  const std::filesystem::path map = file("x,y,z,thickness_mm\n0,9,0,8\n0,-9,0,0\n");
  const Json found = test::document_of(line + " --cartilage " + map.string())["answer"];
  const TriangleMesh socket = read_mesh(socket_);
  const std::vector<double> area = vertex_areas(socket);
  double expected = 0.0;
  for (std::size_t i = 0; i < area.size(); ++i)
    expected += socket.vertices[i].normalized().y() >= -0.25 ? area[i] : 0.0;
  EXPECT_NEAR(found["impingement"][1]["socket"]["area_mm2"], expected, 0.05 * expected);
  EXPECT_EQ(found["impingement"][0]["socket"]["area_mm2"], 0.0);
}

// The histogram holds the area of the surface; a joint space of 3 mm fills the bin from 3 mm, or that before
// it where the table falls short of the mesh.
TEST_F(Cartilage, GapsOfAHipAreInTheHistogram) {
  const Json found = test::document_of(hip({.joint_space = 3.05, .fossa_depth = 0.0}));
  const Json& histogram = found["answer"]["gap_histogram"];
  EXPECT_EQ(histogram["first_mm"], -5.0);
  const Json& socket = histogram["socket"];
  double total = 0.0;
  for (const double x : socket["area_mm2"]) total += x;
  EXPECT_GT(socket["area_mm2"][16], 0.95 * total);
  EXPECT_EQ(socket["without_gap_mm2"], 0.0);
}

// A ball that is too large for its socket is not taken for it.
TEST_F(Cartilage, ABallThatPenetratesAllOverIsAnAnswer) {
  const std::string line = hip({.joint_space = 1.0});
  TriangleMesh ball = read_mesh(ball_);
  for (Vec3& v : ball.vertices) v *= 1.1;
  write_mesh(ball_, ball);
  EXPECT_LT(test::document_of(line)["answer"]["smallest_gap"]["gap_mm"], -1.0);
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// The cells that a scene writes sum to all rotations, and an interrupted run ends with the same bytes.
#include "scene/volume.hpp"

#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "files/file_bytes.hpp"
#include "hip/named_motion.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/ply_writer.hpp"
#include "rotations/rotation_cells.hpp"
#include "scene/report.hpp"
#include "support/temporary_folder.hpp"

namespace impinge {
namespace {

// The cam's pair, asked for all rotations into the folder of that name.
class SceneVolume : public testing::Test {
 protected:
  SceneVolume() {
    const BallSocketPair pair = make_ball_socket_pair(400, impinging_cam());
    write_ply(folder_.path() / "ball.ply", pair.ball);
    write_ply(folder_.path() / "socket.ply", pair.socket);
  }
  SceneOptions options(const std::string& out) const {
    SceneOptions asked;
    asked.ball = folder_.path() / "ball.ply";
    asked.socket = folder_.path() / "socket.ply";
    asked.out = folder_.path() / out;
    asked.centre = Vec3::Zero();
    asked.side = Side::right;
    asked.question = Question::first_contact;
    asked.volume = VolumeOptions{0.3, 0.0, 0.0};
    std::filesystem::create_directories(asked.out);
    return asked;
  }
  static nlohmann::json run(const SceneOptions& asked) {
    std::ostringstream log;
    const Session session = load_joint(asked);
    return write_volume(asked, *session.joint, log);
  }

  test::TemporaryFolder folder_;
};

TEST_F(SceneVolume, WritesCellsThatSumToAllRotations) {
  const SceneOptions asked = options("whole");
  const nlohmann::json found = run(asked);
  std::istringstream rows(read_bytes(asked.out / "volume.csv"));
  std::string row;
  std::getline(rows, row);
  EXPECT_EQ(row, "level,cell,w,x,y,z,radius_deg,share,state,reachable");
  double free = 0.0;
  double all = 0.0;
  while (std::getline(rows, row)) {
    std::vector<std::string> cells;
    std::istringstream line(row + ",");
    for (std::string cell; std::getline(line, cell, ',');) cells.push_back(cell);
    ASSERT_EQ(cells.size(), 10U) << row;
    all += std::stod(cells[7]);
    free += cells[8] == "free" ? std::stod(cells[7]) : 0.0;
  }
  EXPECT_NEAR(all, 1.0, kShareError);
  EXPECT_NEAR(free, found["share_low"].get<double>(), 2.0 * kShareError);
  EXPECT_LE(found["open"].get<double>(), 0.3);
  EXPECT_EQ(found["motions"].size(), named_motions().size());
  EXPECT_TRUE(read_bytes(asked.out / "volume.svg").starts_with("<svg"));
}

TEST_F(SceneVolume, GoesOnWhereItWasInterrupted) {
  const SceneOptions whole = options("whole");
  run(whole);
  const SceneOptions asked = options("again");
  std::filesystem::create_directories(asked.out / "volume.csv");  // which cannot be written then
  EXPECT_THROW(run(asked), std::exception);
  std::filesystem::path part;
  for (const auto& file : std::filesystem::directory_iterator(asked.out))
    if (file.path().extension() == ".part") part = file.path();
  ASSERT_FALSE(part.empty());
  std::filesystem::remove(asked.out / "volume.csv");
  const std::string verdicts = read_bytes(part);
  std::string changed = verdicts;
  changed[12 + 20 * (verdicts.size() / 40)] ^= 1;  // the state of a cell half way
  for (const std::string& left : {verdicts.substr(0, verdicts.size() / 2 + 7),  // killed in a verdict
                                  std::string(), std::string(verdicts.size(), '\0'), changed}) {
    write_bytes(part, left);
    run(asked);
    for (const char* file : {"volume.csv", "volume.json", "volume.svg"})
      EXPECT_EQ(read_bytes(asked.out / file), read_bytes(whole.out / file)) << file;
    EXPECT_FALSE(std::filesystem::exists(part));
  }
}

}  // namespace
}  // namespace impinge

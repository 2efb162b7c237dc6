// SPDX-License-Identifier: GPL-3.0-or-later
// The cells that `impinge volume` writes sum to all rotations, and an interrupted run ends with the same
// bytes.
#include "joint/volume.hpp"

#include <cmath>
#include <filesystem>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "command/answer_key.hpp"
#include "files/file_bytes.hpp"
#include "hip/named_motion.hpp"
#include "limits/body_pairs.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/io.hpp"
#include "rotations/rotation_cells.hpp"
#include "support/command_line.hpp"
#include "support/opened.hpp"
#include "support/temporary_folder.hpp"

namespace impinge {
namespace {

// The cam's pair, asked for all rotations into the folder of that name.
class VolumeCommand : public testing::Test {
 protected:
  VolumeCommand() {
    const BallSocketPair pair = make_ball_socket_pair(400, impinging_cam());
    write_mesh(folder_.path() / "ball.ply", pair.ball);
    write_mesh(folder_.path() / "socket.ply", pair.socket);
  }
  // Its exit code; what it says beside the answer goes to `log_`.
  int run(const std::filesystem::path& out, const std::string& more = "") {
    const test::Ran ran = test::run("volume " + (folder_.path() / "ball.ply").string() + " " +
                                    (folder_.path() / "socket.ply").string() +
                                    " --centre 0,0,0 --side right --width 0.3 --out " + out.string() + more);
    log_ = ran.log;
    return ran.code;
  }

  test::TemporaryFolder folder_;
  std::string log_;
};

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream line(row + ",");
  for (std::string cell; std::getline(line, cell, ',');) cells.push_back(cell);
  return cells;
}

TEST_F(VolumeCommand, WritesCellsThatSumToAllRotations) {
  const std::filesystem::path out = folder_.path() / "whole";
  ASSERT_EQ(run(out), 0);
  const Json found = Json::parse(read_bytes(out / "volume.json"));
  EXPECT_EQ(Json::parse(read_bytes(out / "summary.json"))["answer"], found);
  std::istringstream rows(read_bytes(out / "volume.csv"));
  std::string row;
  std::getline(rows, row);
  EXPECT_EQ(row, "level,cell,w,x,y,z,radius_deg,share,free,blocked,state,reachable");
  double free = 0.0;
  double all = 0.0;
  while (std::getline(rows, row)) {
    const std::vector<std::string> cells = cells_of(row);
    ASSERT_EQ(cells.size(), 12U) << row;
    all += std::stod(cells[7]);
    free += std::stod(cells[8]);
  }
  EXPECT_NEAR(all, 1.0, kShareError);
  EXPECT_NEAR(free, found["share_low"].get<double>(), 2.0 * kShareError);
  EXPECT_LE(found["open"].get<double>(), 0.3);
  EXPECT_EQ(found["motions"].size(), named_motions().size());
  EXPECT_TRUE(read_bytes(out / "volume.svg").starts_with("<svg"));
  EXPECT_TRUE(read_bytes(out / "mobility.svg").starts_with("<svg"));
}

// The shift in a row of volume.csv, mm; none if its cells are empty.
std::optional<Vec3> shift_in(const std::string& row) {
  const std::vector<std::string> cells = cells_of(row);
  if (cells.size() != 15 || cells[12].empty()) return std::nullopt;
  return Vec3(std::stod(cells[12]), std::stod(cells[13]), std::stod(cells[14]));
}

TEST_F(VolumeCommand, FreesMoreWithPlayByShiftsWithinIt) {
  constexpr double kPlay = 2.0;
  const std::filesystem::path still = folder_.path() / "still";
  const std::filesystem::path loose = folder_.path() / "loose";
  ASSERT_EQ(run(still), 0);
  ASSERT_EQ(run(loose, " --play 2"), 0) << log_;
  const Json without = Json::parse(read_bytes(still / "volume.json"));
  const Json with = Json::parse(read_bytes(loose / "volume.json"));
  EXPECT_GE(with["share_high"].get<double>(), without["share_low"].get<double>());
  EXPECT_LE(with["reachable_low"].get<double>(), without["reachable_high"].get<double>());
  std::istringstream rows(read_bytes(loose / "volume.csv"));
  std::size_t shifted = 0;
  for (std::string row; std::getline(rows, row);) {
    if (row.starts_with("level")) continue;
    const std::optional<Vec3> shift = shift_in(row);
    EXPECT_EQ(shift.has_value(), row.find(",free,") != std::string::npos) << row;
    if (!shift) continue;
    EXPECT_LE(shift->norm(), kPlay + 1e-9) << row;  // rounded in the file
    if (shift->norm() > 0.0) ++shifted;
  }
  EXPECT_GT(shifted, 0U);
}

// Random poses whose Euler angles are even, in a hundred joint coordinate systems, each asked of the bodies
// themselves.
TEST(VolumeMobility, IsThatOfEulerAnglesAboutWhateverAxes) {
  constexpr int kSystems = 100;
  constexpr int kPoses = 100;
  const BallSocketPair pair = make_ball_socket_pair(400, impinging_cam());
  JointInput input;
  input.ball = {"ball", pair.ball};
  input.socket = {"socket", pair.socket};
  input.centre = Vec3::Zero();
  Session session(assemble_joint(std::move(input)), Side::right, "RAS");
  const VolumeAnswer found = answer(session, VolumeRequest{.width = 0.1});
  const BodyPairs bodies(pair, {});
  std::mt19937_64 engine(53);
  std::uniform_real_distribution<double> even;
  std::normal_distribution<double> normal;
  const auto turned = [&]() -> Eigen::Matrix3d {
    return Eigen::Quaterniond(normal(engine), normal(engine), normal(engine), normal(engine))
        .normalized()
        .toRotationMatrix();
  };
  double sum = 0.0;
  for (int system = 0; system < kSystems; ++system) {
    const Eigen::Matrix3d pelvis = turned();
    const Eigen::Matrix3d femur = turned();
    double mean = 0.0;
    for (int k = 0; k < kPoses; ++k) {
      const double middle = kPi * (even(engine) - 0.5);
      const Eigen::Quaterniond q = Eigen::AngleAxisd(2.0 * kPi * even(engine), Vec3::UnitZ()) *
                                   Eigen::AngleAxisd(middle, Vec3::UnitY()) *
                                   Eigen::AngleAxisd(2.0 * kPi * even(engine), Vec3::UnitX());
      const bool free =
          bodies.verdict({pelvis * q.toRotationMatrix() * femur, Vec3::Zero()}).contact == Contact::no;
      mean += free ? std::cos(middle) / kPoses : 0.0;
    }
    const double mobility = 360.0 * 180.0 * 360.0 * mean;
    constexpr double kSpread = 5.0 * 360.0 * 180.0 * 360.0 * 0.5 / 10.0;  // five standard deviations at most
    EXPECT_GT(mobility, found.mobility_low_deg3() - kSpread);
    EXPECT_LT(mobility, found.mobility_high_deg3() + kSpread);
    sum += mobility;
  }
  constexpr double kSpread = 5.0 * 360.0 * 180.0 * 360.0 * 0.5 / 100.0;
  EXPECT_GT(sum / kSystems, found.mobility_low_deg3() - kSpread);
  EXPECT_LT(sum / kSystems, found.mobility_high_deg3() + kSpread);
}

TEST(VolumeOfOpenBones, SaysWhichHaveNoInside) {
  const test::TemporaryFolder folder;
  const auto log = [&](double mouth) {
    return test::run("volume" + test::speck_in_flask(folder.path(), mouth) + " --width 0.9").log;
  };
  const std::string said = "openings leave it open what is inside of speck and of flask: ";
  EXPECT_NE(log(1.5).find(said), std::string::npos) << log(1.5);
  EXPECT_EQ(log(0.1).find(said), std::string::npos) << "a flask has an inside";
}

TEST_F(VolumeCommand, GoesOnWhereItWasInterrupted) {
  const std::filesystem::path whole = folder_.path() / "whole";
  const std::filesystem::path again = folder_.path() / "again";
  ASSERT_EQ(run(whole), 0);
  std::filesystem::create_directories(again / "volume.csv");  // which cannot be written then
  EXPECT_EQ(run(again), 1);
  std::filesystem::path part;
  for (const auto& file : std::filesystem::directory_iterator(again))
    if (file.path().extension() == ".part") part = file.path();
  ASSERT_FALSE(part.empty());
  std::filesystem::remove(again / "volume.csv");
  const std::string verdicts = read_bytes(part);
  std::string changed = verdicts;
  changed[12 + 24 * (verdicts.size() / 48)] ^= 1;  // the state of a cell half way
  for (const std::string& left : {verdicts.substr(0, verdicts.size() / 2 + 7),  // killed in a verdict
                                  std::string(), std::string(verdicts.size(), '\0'), changed}) {
    write_bytes(part, left);
    EXPECT_EQ(run(again), 0);
    const bool some = left.starts_with(verdicts.substr(0, 24));
    EXPECT_EQ(log_.find("cells were decided before") != std::string::npos, some);
    for (const char* file : {"volume.csv", "volume.json", "volume.svg", "mobility.svg"})
      EXPECT_EQ(read_bytes(again / file), read_bytes(whole / file)) << file;
    EXPECT_FALSE(std::filesystem::exists(part));
  }
}

TEST(AnswerKey, IsOfMeshesSideRequestAndVersion) {
  const auto key = [](double moved, std::optional<Side> side, const Json& request, const char* version) {
    const auto [ball, socket] = make_ball_socket_pair(400, impinging_cam());
    JointInput input;
    input.ball = {"ball", ball};
    input.socket = {"socket", socket};
    input.centre = Vec3::Zero();
    input.socket.mesh.vertices.back().x() += moved;
    return answer_key(SessionJoint(assemble_joint(std::move(input)), side, "RAS"), request, version);
  };
  const std::set<std::string> keys{key(0.0, Side::left, 1, "1"), key(1e-12, Side::left, 1, "1"),
                                   key(0.0, std::nullopt, 1, "1"), key(0.0, Side::left, 2, "1"),
                                   key(0.0, Side::left, 1, "2")};
  EXPECT_EQ(keys.size(), 5U);
  EXPECT_TRUE(keys.contains(key(0.0, Side::left, 1, "1")));
}

}  // namespace
}  // namespace impinge

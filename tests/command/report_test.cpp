// SPDX-License-Identifier: GPL-3.0-or-later
// A report has what each of its questions says alone, and its clock the gaps of joints of known gap.
#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "command/joint_options.hpp"
#include "files/file_bytes.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/io.hpp"
#include "report/clock.hpp"
#include "support/command_line.hpp"
#include "support/temporary_folder.hpp"

namespace impinge {
namespace {

// Of a right hip: its socket opens to the right.
class Report : public ::testing::Test {
 protected:
  void write(const TriangleMesh& ball, TriangleMesh socket) const {
    for (Vec3& v : socket.vertices) v = Vec3(-v.z(), v.y(), v.x());
    write_mesh(files_.ball, ball);
    write_mesh(files_.socket, socket);
  }
  void write_cam() const {
    BallSocketPair pair = make_ball_socket_pair(400, impinging_cam());
    for (Vec3& v : pair.ball.vertices) v = Vec3(-v.z(), v.y(), v.x());
    write(pair.ball, pair.socket);
  }
  test::Ran ask(const std::string& question, const std::string& folder,
                const std::string& options = "") const {
    return test::run(question + " " + files_.ball.string() + " " + files_.socket.string() +
                     " --centre 0,0,0 --out " + (folder_.path() / folder).string() + " " + options);
  }
  std::string bytes(const std::string& file) const { return read_bytes(folder_.path() / file); }
  // The clock of the pose of the scan.
  ClockMap clock() const {
    Session session = load_joint(files_, {});
    return clock_map(*session.joint, answer(session, GapsRequest{})).value();
  }

  test::TemporaryFolder folder_;
  JointOptions files_{
      {.centre = Vec3(0.0, 0.0, 0.0)}, folder_.path() / "ball.ply", folder_.path() / "socket.ply"};
};

TEST_F(Report, ClockHasTheGapOfConcentricSpheresToTheRim) {
  write(sphere(22.0, 20000), cup(25.0, 80.0, 10000));
  const ClockMap map = clock();
  ASSERT_EQ(map.rows, 27U);  // of 3 degrees
  for (std::size_t cell = 0; cell < 26 * ClockMap::kColumns; ++cell)
    ASSERT_NEAR(map.gap_mm[cell], 3.0, 0.03) << cell / ClockMap::kColumns << " " << cell % ClockMap::kColumns;
}

TEST_F(Report, ClockIsNarrowAtThreeWhereTheBallLiesForward) {
  write(sphere(22.0, 20000, Vec3(0.0, 1.0, 0.0)), cup(25.0, 80.0, 10000));
  const ClockMap map = clock();
  for (std::size_t row = 0; row < 26; ++row) {
    for (std::size_t column = 0; column < ClockMap::kColumns; ++column) {
      const double forward =
          std::sin(ClockMap::angle_deg(row) * kDegree) * std::sin(ClockMap::hours(column) * 30.0 * kDegree);
      const double radius = forward + std::sqrt(22.0 * 22.0 - 1.0 + forward * forward);
      ASSERT_NEAR(map.gap_mm[row * ClockMap::kColumns + column], 25.0 - radius, 0.04) << row << " " << column;
    }
  }
}

TEST_F(Report, HasWhatItsQuestionsSayAlone) {
  write_cam();
  ASSERT_EQ(ask("report", "all", "--side right --width 0.4").code, 0);
  ASSERT_EQ(ask("limits", "limits", "--side right").code, 0);
  ASSERT_EQ(ask("measure", "measure", "--side right").code, 0);
  ASSERT_EQ(ask("gaps", "gaps", "--outputs gaps,verdicts").code, 0);
  ASSERT_EQ(ask("volume", "volume", "--side right --width 0.4").code, 0);
  EXPECT_EQ(bytes("all/limits.csv"), bytes("limits/limits.csv"));
  EXPECT_EQ(bytes("all/measures.csv"), bytes("measure/measures.csv"));
  EXPECT_EQ(bytes("all/gaps.csv"), bytes("gaps/gaps.csv"));
  EXPECT_EQ(bytes("all/volume.svg"), bytes("volume/volume.svg"));
  const Json said = Json::parse(bytes("all/summary.json"))["answer"];
  EXPECT_EQ(said["limits"], Json::parse(bytes("limits/summary.json"))["answer"]);
  EXPECT_EQ(said["volume"], Json::parse(bytes("volume/summary.json"))["answer"]);
  EXPECT_EQ(said["gaps"]["contact"], Json::parse(bytes("gaps/summary.json"))["answer"]["contact"]);
}

TEST_F(Report, IsTheSameWhereverItLies) {
  write_cam();
  ASSERT_EQ(ask("report", "one", "--side right --width 0.5").code, 0);
  ASSERT_EQ(ask("report", "other", "--side right --width 0.5 --threads 1").code, 0);
  const std::string page = bytes("one/report.html");
  EXPECT_EQ(page, bytes("other/report.html"));
  EXPECT_EQ(page.find(folder_.path().string()), page.npos);
  for (const char* picture : {"clock.svg", "limits.svg", "volume.svg"})
    EXPECT_NE(page.find(bytes(std::string("one/") + picture)), page.npos) << picture;
}

TEST_F(Report, LeavesOutWhatIsNotAskedFor) {
  write_cam();
  ASSERT_EQ(ask("report", "short", "--side right --without volume,measures --pose flexion=-20").code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "short/limits.svg"));
  for (const char* file : {"volume.svg", "measures.csv", "measures.svg"})
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "short" / file)) << file;
  const std::string page = bytes("short/report.html");
  EXPECT_NE(page.find("flexion -20°"), page.npos);
  EXPECT_EQ(page.find("id=\"measures\""), page.npos);
}

TEST_F(Report, NamesWhatItNeeds) {
  write_cam();
  EXPECT_NE(ask("report", "no_side").log.find("side: a report needs to know it"), std::string::npos);
  const test::Ran nowhere =
      test::run("report " + files_.ball.string() + " " + files_.socket.string() + " --side right");
  EXPECT_EQ(nowhere.code, 2);
  EXPECT_NE(nowhere.log.find("--out: a report needs a folder"), std::string::npos) << nowhere.log;
}

}  // namespace
}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// What is read of a command line; what is refused: tests/e2e/bad_options.py.
#include <string>

#include <gtest/gtest.h>

#include "command/joint_options.hpp"
#include "joint/gaps.hpp"
#include "joint/limits.hpp"
#include "joint/orient.hpp"
#include "joint/resect.hpp"
#include "support/command_line.hpp"
#include "support/temporary_folder.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

JointOptions joint_of(const std::string& line) {
  CLI::App app;
  JointOptions options;
  const auto use_config = add_joint_options(app, options);
  app.parse(line);
  use_config();
  return options;
}

TEST(JointOptions, Defaults) {
  const JointOptions options = joint_of("");
  EXPECT_FALSE(options.centre);
  EXPECT_FALSE(options.side);
  EXPECT_FALSE(options.axes);
  EXPECT_FALSE(options.keep_largest);
  EXPECT_FALSE(options.cartilage_mm);
}

TEST(JointOptions, AreReadAsTheyAreWritten) {
  const JointOptions options = joint_of(
      "--centre -86.03,-20.18,-579.65 --side left --axes LPS --cartilage 2.5 --keep largest --overlap 0.3 "
      "--ball-part a.ply --ball-part b.ply --socket-part c.ply");
  EXPECT_EQ(*options.centre, Vec3(-86.03, -20.18, -579.65));
  EXPECT_EQ(options.side, Side::left);
  EXPECT_EQ(options.axes, "LPS");
  EXPECT_EQ(options.cartilage_mm, 2.5);
  EXPECT_TRUE(options.keep_largest);
  EXPECT_EQ(options.overlap_mm, 0.3);
  EXPECT_EQ(options.ball_parts, (std::vector<std::filesystem::path>{"a.ply", "b.ply"}));
  EXPECT_FALSE(joint_of("--centre fit").centre);
}

TEST(JointOptions, CountBeforeWhatAFileSays) {
  const test::TemporaryFolder folder;
  const std::string config = folder.write("joint.json", R"({"side": "left", "axes": "LPS", "cartilage_mm": 3,
      "centre": [1, 2, 3], "ball_part": "a.ply"})");
  const JointOptions options = joint_of("--axes RAS --config " + config);
  EXPECT_EQ(options.side, Side::left);
  EXPECT_EQ(options.axes, "RAS");
  EXPECT_EQ(options.cartilage_mm, 3.0);
  EXPECT_EQ(*options.centre, Vec3(1.0, 2.0, 3.0));
  EXPECT_EQ(options.ball_parts, std::vector<std::filesystem::path>{folder.path() / "a.ply"});
}

// By letter and sign, not by the order of words.
TEST(JointOptions, ReadAxesInWords) {
  const test::TemporaryFolder folder;
  const auto axes = [&](const std::string& text) {
    return joint_of("--config " + folder.write("joint.json", R"({"axes": ")" + text + R"("})").string()).axes;
  };
  EXPECT_EQ(axes("LPS"), "LPS");
  EXPECT_EQ(axes("+x = patient left, +y = posterior, +z = superior (LPS)"), "LPS");
  EXPECT_EQ(axes("+x=left, +y=posterior, +z=superior"), "LPS");
  EXPECT_EQ(axes("+z = superior, +x = right, +y = anterior"), "RAS");
  EXPECT_EQ(axes("-x = left, -y = posterior, +z = superior"), "RAS");
  EXPECT_EQ(axes("+x = anterior, +y = superior, +z = patient right (OpenSim ground axes)"), "ASR");
  for (const char* bad :
       {"", "as scanned", "x = left, y = posterior, z = superior", "+x = left, +y = posterior",
        "+x = left, +x = posterior, +z = superior", "+x = left; +y = posterior; +z = superior",
        "+x = left, +y = posterior, +z = superior, +x = right", "+x = left, +y = up, +z = superior"})
    EXPECT_NE(test::thrown<std::runtime_error>([&] { axes(bad); }).find("joint.json: axis code"),
              std::string::npos)
        << bad;
}

TEST(RequestOptions, AreThoseOfTheRequest) {
  GapsRequest gaps;
  EXPECT_EQ(test::asked(gaps_question(), "").request(), json_of(gaps));
  gaps.precision_deg = 0.1;
  gaps.scheme = "usid";
  gaps.pose = {.flexion = 90.0, .internal_rotation = 10.0};
  gaps.outputs = {Output::gaps, Output::distances};
  EXPECT_EQ(test::asked(gaps_question(),
                        "--pose flexion=90,internal_rotation=10 --scheme usid --precision 0.1 "
                        "--outputs gaps,distances")
                .request(),
            json_of(gaps));
  GapsRequest ball;
  ball.max_error_mm = 0.05;
  ball.surfaces = Scanned::ball;
  ball.outputs = {Output::gaps};
  EXPECT_EQ(test::asked(gaps_question(), "--max-error 0.05 --surfaces ball --outputs gaps").request(),
            json_of(ball));
}

TEST(RequestOptions, ReadMotionsPlacesAndLists) {
  LimitsRequest limits;
  limits.motions = {"extension", "adduction"};
  limits.pose = Motion{.flexion = 20.0};
  limits.translation = Vec3(0.0, -1.5, 2.0);
  EXPECT_EQ(
      test::asked(limits_question(), "--motions extension,adduction --pose flexion=20 --translation 0,-1.5,2")
          .request(),
      json_of(limits));
  ResectRequest resect;
  resect.require = {{.flexion = 90.0, .internal_rotation = 30.0}, {.flexion = -20.0}};
  resect.clearance_mm = 1.5;
  resect.neck_mm = 20.0;
  EXPECT_EQ(test::asked(resect_question(),
                        "--require flexion=90,internal_rotation=30 --require extension=20 --clearance 1.5 "
                        "--neck 20")
                .request(),
            json_of(resect));
  ResectRequest socket;
  socket.require = {{.flexion = 90.0}};
  socket.cut = Surface::socket;
  socket.rim_mm = 3.0;
  EXPECT_EQ(test::asked(resect_question(), "--require flexion=90 --cut socket --rim 3").request(),
            json_of(socket));
  OrientRequest orient;
  orient.require = {{.flexion = 90.0}};
  orient.tilt_deg = -7.5;
  EXPECT_EQ(test::asked(orient_question(), "--require flexion=90 --tilt -7.5").request(), json_of(orient));
}

}  // namespace
}  // namespace impinge

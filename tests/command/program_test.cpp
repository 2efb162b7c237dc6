// SPDX-License-Identifier: GPL-3.0-or-later
// The program on whole command lines: what it says, where it writes, and its exit code.
#include "command/program.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "command/request_options.hpp"
#include "files/file_bytes.hpp"
#include "support/command_line.hpp"
#include "support/temporary_folder.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kQuestions{"gaps",   "touch",  "poses",   "limits",  "volume",
                                          "resect", "orient", "measure", "certify", "report"};

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

// What is refused is said in one line, and there is no answer.
void expect_refused(const std::string& line, int code, const std::string& said) {
  const test::Ran ran = test::run(line);
  EXPECT_EQ(ran.code, code) << line;
  EXPECT_EQ(ran.out, "") << line;
  EXPECT_TRUE(has(ran.log, said)) << line << ": " << ran.log;
  EXPECT_EQ(ran.log.find("impinge: error: "), 0U) << ran.log;
  EXPECT_EQ(std::count(ran.log.begin(), ran.log.end(), '\n'), 1) << ran.log;
}

TEST(Program, RefusesWrongCommandsAndOptions) {
  expect_refused("gasp a.ply b.ply", 2, "impinge: there is no 'gasp'; did you mean gaps? There are gaps, ");
  expect_refused(
      "gaps a.ply b.ply --precison 1", 2,
      "--precison: is no option of impinge gaps; did you mean --precision? See impinge gaps --help");
  expect_refused("gaps a.ply b.ply --precision fine", 2,
                 "--precision: 'fine' is no number; give one that is above 0");
  expect_refused("gaps a.ply b.ply --precision ''", 2,
                 "--precision: is empty; give it a value or leave it out");
  expect_refused("gaps '' b.ply", 2, "BALL: is empty; give it a value or leave it out");
  expect_refused("gaps a.ply b.ply --surfaces ball", 2, "--surfaces: one alone has neither bounds");
  expect_refused("limits a.ply b.ply --motions bend", 2, "--motions: unknown motion 'bend'");
  expect_refused("gaps", 2, "two meshes are needed, BALL and SOCKET; see impinge gaps --help");
  expect_refused("gaps a.ply b.ply stray", 2, "was not expected; see impinge gaps --help");
  const test::Ran nothing = test::run("");
  EXPECT_EQ(nothing.code, 2);
  for (const std::string& question : kQuestions) EXPECT_TRUE(has(nothing.out, "  " + question)) << question;
}

TEST(Program, RefusesFilesThatCannotBeUsed) {
  const test::TemporaryFolder folder;
  const std::string out = folder.path() / "one/two";
  expect_refused("gaps nowhere.ply nowhere.ply --out " + out, 1, "nowhere.ply: ");
  EXPECT_FALSE(fs::exists(folder.path() / "one")) << "a folder without an answer is taken away";
  const std::string bad = folder.write("bad.ply", "ply\n");
  expect_refused("touch " + bad + " " + bad, 1, bad + ": ");
}

TEST(Program, SaysItsVersion) {
  const test::Ran ran = test::run("--version");
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.out.find("impinge "), 0U) << ran.out;
  EXPECT_TRUE(has(ran.out, " (commit ")) << ran.out;
}

// It can be parsed as it stands.
TEST(Program, HelpEndsWithAnExample) {
  for (std::string command : kQuestions) {
    const test::Ran ran = test::run(command + " --help");
    EXPECT_EQ(ran.code, 0);
    const std::size_t at = ran.out.find("Example: impinge " + command + " ");
    ASSERT_NE(at, ran.out.npos) << ran.out;
    const std::string example = ran.out.substr(at + 17, ran.out.find('\n', at) - at - 17);
    const test::CommandLine line(example);
    EXPECT_TRUE(parse_program(line.argc(), line.argv(), {std::cout, std::cerr})) << example;
  }
  for (const char* command : {"hip", "check"})
    EXPECT_TRUE(has(test::run(command + std::string(" --help")).out, "Example: impinge ")) << command;
}

TEST(Program, PrintsASchemaOfEachDocument) {
  for (const std::string& command : kQuestions) {
    const test::Ran ran = test::run(command + " --schema");
    ASSERT_EQ(ran.code, 0) << ran.log;
    const Json schema = Json::parse(ran.out);
    EXPECT_EQ(schema["title"], "impinge " + command);
    const std::string help = test::run(command + " --help").out;
    for (const auto& [key, property] : schema["properties"]["request"]["properties"].items())
      EXPECT_TRUE(has(help, option_name(key))) << command << " " << key;
  }
}

class ProgramOnAHip : public testing::Test {
 protected:
  ProgramOnAHip() {
    const test::Ran ran = test::run("hip cam --faces 600 --out " + hip_.string());
    EXPECT_EQ(ran.code, 0) << ran.log;
  }
  std::string meshes() const { return (hip_ / "ball.ply").string() + " " + (hip_ / "socket.ply").string(); }

  test::TemporaryFolder folder_;
  const fs::path hip_ = folder_.path() / "joints/cam";
  const fs::path out_ = folder_.path() / "out";
};

TEST_F(ProgramOnAHip, PrintsTheDocumentThatItWrites) {
  Json printed = test::document_of("touch " + meshes() + " --side right --out " + out_.string());
  Json written = Json::parse(read_bytes(out_ / "summary.json"));
  EXPECT_EQ(written["files"], Json::array({"summary.json"}));
  EXPECT_EQ(written["command"], "touch");
  written.erase("files");
  printed.erase("files");
  EXPECT_EQ(printed, written);
  Json keys = Json::array();
  for (const auto& [key, value] : printed.items()) keys.push_back(key);
  keys.push_back("files");
  EXPECT_EQ(Json::parse(test::run("touch --schema").out)["required"], keys);
}

// A thickness of cartilage that changes no answer is not passed over in silence; as an option it is refused
// (tests/e2e/bad_options.py).
TEST_F(ProgramOnAHip, SaysThatBonesAloneWereUsed) {
  const fs::path config = folder_.write("joint.json", R"({"side": "right", "cartilage_mm": 3})");
  const auto warned = [&](const std::string& line) {
    const std::string text =
        test::document_of(line + " --config " + config.string())["joint"]["warnings"].dump();
    return has(text, "the thickness of cartilage is left out: this answer is about bones alone");
  };
  EXPECT_TRUE(warned("touch " + meshes()));
  EXPECT_TRUE(warned("measure " + meshes()));
  EXPECT_TRUE(warned("poses " + meshes() + " --path flexion=0"));
  EXPECT_FALSE(warned("poses " + meshes() + " --path flexion=0 --outputs areas"));
  EXPECT_FALSE(warned("gaps " + meshes() + " --outputs gaps"));
  EXPECT_FALSE(warned("limits " + meshes() + " --motions flexion"));
}

TEST_F(ProgramOnAHip, SaysWhichFilesAreOfAnEarlierCommand) {
  const std::string rest = meshes() + " --side right --outputs gaps --out " + out_.string();
  for (int k = 0; k < 2; ++k) EXPECT_FALSE(has(test::run("gaps " + rest).log, "earlier")) << k;
  const test::Ran touch = test::run("touch " + meshes() + " --side right --out " + out_.string());
  EXPECT_EQ(touch.code, 0);
  EXPECT_TRUE(has(touch.log, "impinge: warning: " + out_.string() +
                                 "/{ball.ply,socket.ply,gaps.csv} is left from an earlier command"))
      << touch.log;
}

TEST_F(ProgramOnAHip, ReplacesNoInput) {
  const fs::path poses = hip_ / "poses.csv";
  const fs::path config = hip_ / "summary.json";
  write_bytes(poses, "flexion\n10\n");
  write_bytes(config, R"({"side": "right"})");
  const auto files = [&] {
    std::map<fs::path, std::string> bytes;
    for (const auto& file : fs::directory_iterator(hip_)) bytes[file] = read_bytes(file);
    return bytes;
  };
  const auto before = files();
  for (const std::string& line : {"gaps " + meshes(), "touch " + meshes() + " --config " + config.string(),
                                  "poses " + meshes() + " --side right --poses " + poses.string()}) {
    const test::Ran ran = test::run(line + " --out " + hip_.string());
    EXPECT_EQ(ran.code, 1) << line;
    EXPECT_TRUE(has(ran.log, "would be replaced by the output; choose another folder with --out")) << ran.log;
    EXPECT_EQ(files(), before) << line;
  }
}

TEST_F(ProgramOnAHip, AsksAllJointsOfAFolder) {
  const fs::path joints = hip_.parent_path();
  EXPECT_EQ(test::run("hip normal --faces 600 --out " + (joints / "normal").string()).code, 0);
  fs::create_directory(joints / "empty");
  const std::string rest = " --joints " + joints.string() + " --side right --out " + out_.string();
  const test::Ran ran = test::run("limits --motions flexion" + rest);
  EXPECT_EQ(ran.code, 0);
  EXPECT_TRUE(has(ran.log, "impinge: joint 2 of 2, normal\n")) << ran.log;
  EXPECT_TRUE(has(ran.log, "impinge: warning: left out: ")) << ran.log;
  const Json all = Json::parse(read_bytes(out_ / "summary.json"));
  ASSERT_EQ(all["documents"].size(), 2U);
  EXPECT_EQ(all["left_out"].size(), 1U);
  std::string head;
  std::string rows;
  for (const char* name : {"cam", "normal"}) {
    const std::string ball = joints / name / "ball.ply";
    const std::string socket = joints / name / "socket.ply";
    const Json alone = test::document_of("limits " + ball + " " + socket + " --side right --motions flexion");
    EXPECT_EQ(Json::parse(read_bytes(out_ / name / "summary.json"))["answer"], alone["answer"]);
    std::istringstream table(read_bytes(out_ / name / "limits.csv"));  // of one joint, without its name
    std::getline(table, head);
    for (std::string row; std::getline(table, row);) rows += name + row + "\n";
  }
  EXPECT_EQ(read_bytes(out_ / "limits.csv"), head + "\n" + rows);
  EXPECT_EQ(test::run("touch" + rest).code, 0);
  const std::string table = read_bytes(out_ / "joints.csv");
  EXPECT_EQ(table.find("joint,contact,by,smallest_gap_mm,"), 0U) << table;
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 3) << table;
}

TEST_F(ProgramOnAHip, ManyJointsNeedAFolderForTheirAnswers) {
  const std::string joints = "gaps --joints " + hip_.parent_path().string();
  expect_refused(joints, 2, "--joints requires --out");
  expect_refused(joints + " --out " + out_.string() + " a.ply b.ply", 2, "BALL excludes --joints");
  expect_refused(joints + "/nowhere --out " + out_.string(), 1, "nowhere: ");
}

}  // namespace
}  // namespace impinge

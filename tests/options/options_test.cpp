// SPDX-License-Identifier: GPL-3.0-or-later
// What is read; what is refused: tests/e2e/bad_options.py.
#include "scene/options.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace impinge {
namespace {

std::optional<SceneOptions> parse(std::vector<const char*> more) {
  std::vector<const char*> argv{"scene", "--ball", "b.ply", "--socket", "s.ply", "--out", "o"};
  argv.insert(argv.end(), more.begin(), more.end());
  std::string help;
  return parse_scene_options(static_cast<int>(argv.size()), argv.data(), help);
}

TEST(SceneOptions, Defaults) {
  const auto options = parse({});
  ASSERT_TRUE(options);
  EXPECT_EQ(options->ball, "b.ply");
  EXPECT_EQ(options->socket, "s.ply");
  EXPECT_EQ(options->out, "o");
  EXPECT_FALSE(options->centre);
  EXPECT_EQ(options->scheme, "rsid");
  EXPECT_FALSE(options->by_tables()) << "the faces answer a single pose";
  EXPECT_EQ(parse({"--scheme", "usid"})->precision_deg, 0.5);
  EXPECT_FALSE(options->max_error_mm);
  EXPECT_FALSE(options->side);
  EXPECT_EQ(options->axes, "RAS");
  EXPECT_EQ(options->cartilage_mm, 4.0);
}

TEST(SceneOptions, ReadsAllOfTheContract) {
  const auto options =
      parse({"--centre", "-86.03,-20.18,-579.65", "--scheme", "rsid", "--precision", "0.1", "--pose",
             "flexion=90,internal_rotation=10", "--side", "left", "--axes", "LPS", "--cartilage", "2.5"});
  ASSERT_TRUE(options);
  EXPECT_EQ(*options->centre, Vec3(-86.03, -20.18, -579.65));
  EXPECT_EQ(options->precision_deg, 0.1);
  EXPECT_EQ(options->motion.flexion, 90.0);
  EXPECT_EQ(options->motion.internal_rotation, 10.0);
  EXPECT_EQ(options->side, Side::left);
  EXPECT_EQ(options->axes, "LPS");
  EXPECT_EQ(options->cartilage_mm, 2.5);
  EXPECT_EQ(*parse({"--max-error", "0.05"})->max_error_mm, 0.05);
  EXPECT_FALSE(parse({"--centre", "fit"})->centre);
}

TEST(SceneOptions, ReadsWhichBoneIsCut) {
  const auto options =
      parse({"--question", "resection", "--require", "flexion=90", "--cut", "socket", "--rim", "3"});
  EXPECT_EQ(options->change->cut, Surface::socket);
  EXPECT_EQ(options->change->most_rim_mm, 3.0);
  EXPECT_EQ(parse({"--question", "resection", "--require", "flexion=90", "--cut", "ball"})->change->cut,
            Surface::ball);
}

TEST(SceneOptions, ReadsRequiredMotions) {
  const auto options =
      parse({"--question", "resection", "--side", "left", "--require", "flexion=90,internal_rotation=30",
             "--require", "extension=20", "--clearance", "1.5", "--neck", "20"});
  ASSERT_TRUE(options->change);
  ASSERT_EQ(options->change->required.size(), 2U);
  EXPECT_EQ(options->change->required[0].internal_rotation, 30.0);
  EXPECT_EQ(options->change->required[1].flexion, -20.0);
  EXPECT_EQ(options->change->text, "flexion=90,internal_rotation=30; extension=20");
  EXPECT_EQ(options->change->clearance_mm, 1.5);
  EXPECT_EQ(options->change->least_neck_mm, 20.0);
  EXPECT_FALSE(options->change->of_socket);
  EXPECT_EQ(options->change->cut, Surface::ball);
  EXPECT_FALSE(parse({})->change);
  const auto turned =
      parse({"--question", "orientation", "--side", "right", "--require", "flexion=90", "--tilt", "-7.5"});
  EXPECT_TRUE(turned->change->of_socket);
  EXPECT_EQ(turned->change->tilt_deg, -7.5);
}

TEST(SceneOptions, ReadsWhatTheSceneNeeds) {
  EXPECT_EQ(parse({})->question, Question::all_gaps);
  EXPECT_TRUE(parse({})->outputs.distances);
  const auto touch = parse({"--question", "touch", "--surfaces", "ball"});
  EXPECT_EQ(touch->question, Question::touch);
  EXPECT_TRUE(touch->scan_ball && !touch->scan_socket);
  EXPECT_FALSE(touch->outputs.gaps);
  const auto some = parse({"--outputs", "gaps,distances", "--explain"});
  EXPECT_TRUE(some->outputs.gaps && some->outputs.distances && some->explain);
  EXPECT_FALSE(some->outputs.bounds || some->outputs.verdicts);
  const auto everything = parse({"--everything", "--question", "touch", "--surfaces", "ball"});
  EXPECT_TRUE(everything->outputs.verdicts && everything->scan_socket);
  EXPECT_EQ(everything->question, Question::all_gaps);
}

TEST(SceneOptions, ReadsTheLimitOfAMotion) {
  EXPECT_EQ(parse({})->limit, nullptr);
  const auto options = parse({"--question", "limit", "--motion", "extension", "--pose", "flexion=20"});
  ASSERT_NE(options->limit, nullptr);
  EXPECT_EQ(options->limit->name, "extension");
  EXPECT_EQ(options->motion.flexion, 20.0);
  EXPECT_FALSE(options->outputs.gaps || options->outputs.verdicts);
  EXPECT_EQ(parse({"--everything", "--question", "limit", "--motion", "flexion"})->limit, nullptr);
}

TEST(SceneOptions, HelpNamesEveryOption) {
  std::string help;
  const std::vector<const char*> argv{"scene", "--help"};
  EXPECT_FALSE(parse_scene_options(2, argv.data(), help));
  for (const char* option :
       {"--ball", "--socket", "--out", "--centre", "--scheme", "--precision", "--max-error", "--pose",
        "--side", "--axes", "--cartilage", "--require", "--clearance", "--neck", "--tilt"}) {
    EXPECT_NE(help.find(option), std::string::npos) << option;
  }
}

TEST(SceneOptions, AllRotationsHaveOptionsOfTheirOwn) {
  EXPECT_FALSE(parse({})->volume);
  const auto volume =
      parse({"--question", "volume", "--width", "0.02", "--gap", "4", "--centre-within", "1"})->volume;
  ASSERT_TRUE(volume);
  EXPECT_EQ(volume->width, 0.02);
  EXPECT_EQ(volume->gap_mm, 4.0);
  EXPECT_EQ(volume->centre_within_mm, 1.0);
  EXPECT_TRUE(parse({"--question", "limits", "--side", "left"})->all_motions);
}

}  // namespace
}  // namespace impinge

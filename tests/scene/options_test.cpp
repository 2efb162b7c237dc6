// SPDX-License-Identifier: GPL-3.0-or-later
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
  EXPECT_THROW(parse({"--question", "limit"}), OptionError);
  EXPECT_THROW(parse({"--motion", "flexion"}), OptionError);
  EXPECT_THROW(parse({"--question", "limit", "--motion", "abduction"}), OptionError);
  EXPECT_THROW(parse({"--question", "limit", "--motion", "flexion", "--pose", "flexion=180"}), OptionError);
}

struct Wrong {
  std::vector<const char*> options;
  std::string named;   // what the message must name
  std::string advice;  // and say to do
};

TEST(SceneOptions, RefusalsNameTheOptionAndTheCureInOneLine) {
  const std::vector<Wrong> cases{{{"--precision", "0"}, "--precision", "above 0"},
                                 {{"--precision", "-1"}, "--precision", "above 0"},
                                 {{"--precision", "0.7"}, "--precision", "divides 180"},
                                 {{"--precision", "1e-12"}, "--precision", "at least"},
                                 {{"--precision", "fine"}, "--precision", "number of degrees"},
                                 {{"--precision", "nan"}, "--precision", "number of degrees"},
                                 {{"--precision", "1", "--max-error", "1"}, "--max-error", "--precision"},
                                 {{"--max-error", "0"}, "--max-error", "above 0"},
                                 {{"--max-error", "inf"}, "--max-error", "above 0"},
                                 {{"--scheme", "rside"}, "--scheme", "rsid"},
                                 {{"--centre", "1,2"}, "--centre", "X,Y,Z"},
                                 {{"--centre", "1,2,3,4"}, "--centre", "X,Y,Z"},
                                 {{"--centre", "1,2,nan"}, "--centre", "X,Y,Z"},
                                 {{"--pose", "bend=3"}, "--pose", "flexion"},
                                 {{"--pose", "abduction=3"}, "--pose", "--side"},
                                 {{"--side", "up"}, "--side", "left"},
                                 {{"--axes", "LAS"}, "--axes", "RAS"},
                                 {{"--cartilage", "-1"}, "--cartilage", "0 or more"},
                                 {{"--side", "up\nand\x1b[2J away"}, "--side", "left"},
                                 {{"--colour", "red"}, "--colour", "--help"}};
  for (const Wrong& wrong : cases) {
    try {
      parse(wrong.options);
      FAIL() << wrong.options.front() << ' ' << wrong.options.back() << " was accepted";
    } catch (const OptionError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(wrong.named), std::string::npos) << message;
      EXPECT_NE(message.find(wrong.advice), std::string::npos) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }
}

// What a script types whose variable is not set.
TEST(SceneOptions, EmptyValuesAreRefused) {
  for (const std::size_t k : {2U, 4U, 6U}) {
    std::vector<const char*> argv{"scene", "--ball", "b.ply", "--socket", "s.ply", "--out", "o"};
    argv[k] = "";
    std::string help;
    try {
      parse_scene_options(static_cast<int>(argv.size()), argv.data(), help);
      FAIL() << argv[k - 1];
    } catch (const OptionError& error) {
      EXPECT_EQ(std::string(error.what()),
                std::string("option ") + argv[k - 1] + ": '' is empty; give it a value or leave it out");
    }
  }
}

TEST(SceneOptions, MissingOnesAreNamed) {
  std::string help;
  const std::vector<const char*> argv{"scene", "--ball", "b.ply"};
  try {
    parse_scene_options(3, argv.data(), help);
    FAIL();
  } catch (const OptionError& error) {
    EXPECT_NE(std::string(error.what()).find("--socket"), std::string::npos) << error.what();
  }
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
  EXPECT_THROW(parse({"--question", "limits"}), OptionError);
  EXPECT_THROW(parse({"--question", "volume", "--width", "0"}), OptionError);
  EXPECT_THROW(parse({"--gap", "4"}), OptionError);
  EXPECT_THROW(parse({"--question", "volume", "--path", "flexion=0..90/1"}), OptionError);
}

}  // namespace
}  // namespace impinge

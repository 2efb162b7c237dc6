// SPDX-License-Identifier: GPL-3.0-or-later
// The experiment on what a scene needs, on a small joint and coarse tables.
#include "12_scene_needs/needs_study.hpp"

#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"

namespace impinge::lab {
namespace {

constexpr NeedsOptions kOptions{.precision_deg = 2.0, .rounds = 1};

std::vector<NeedsCase> all_cases() {
  const BallSocketPair joint = make_ball_socket_pair(200, impinging_cam());
  std::vector<NeedsCase> cases;
  for (const NeedsScene& scene : scenes_of("tiny", joint, -Vec3::UnitY())) {
    const auto more = cases_of(scene, kOptions);
    cases.insert(cases.end(), more.begin(), more.end());
  }
  for (const auto& more : {local_change_of("tiny", joint, kOptions), motion_volume_of("tiny", joint)})
    cases.insert(cases.end(), more.begin(), more.end());
  return cases;
}

TEST(NeedsStudy, EveryAnswerIsTheSame) {
  const auto cases = all_cases();
  EXPECT_GT(cases.size(), 15U);
  for (const NeedsCase& work : cases)
    EXPECT_TRUE(work.identical) << work.scene << ", " << work.left_out << ": " << work.difference_mm << " mm";
}

TEST(NeedsStudy, AMotionVolumeAsksForFewerCells) {
  const BallSocketPair joint = make_ball_socket_pair(200, impinging_cam());
  const auto cases = motion_volume_of("tiny", joint);
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_LT(cases[1].bytes, 0.7 * cases[0].bytes);
}

TEST(NeedsStudy, AnOutputIsCountedInEverythingAndNotInTheTables) {
  const auto nothing = [] {};
  const std::vector<NeedsCase> cases{{"joint all gaps", "nothing", nothing, 100.0, true, 0.0},
                                     {"joint all gaps", "entries", nothing, 40.0, true, 0.0},
                                     {"joint all gaps", "distances", nothing, 60.0, true, 0.0},
                                     {"joint all gaps", "all", nothing, 10.0, true, 0.0}};
  Progress silent("test", nullptr);
  const NeedsTables made = time_needs(cases, kOptions, silent);
  ASSERT_EQ(made.needs.columns.size(), 5U);
  ASSERT_EQ(made.needs.rows.size(), 3U);
  EXPECT_EQ(made.needs.rows[0][2].text(), "60");
  EXPECT_EQ(made.needs.rows[1][2].text(), "60");
  EXPECT_EQ(made.needs.rows[2][2].text(), "150");
  ASSERT_EQ(made.totals.rows.size(), 1U);
  EXPECT_EQ(made.totals.rows[0][7].text(), "16") << "everything to plan";
  EXPECT_EQ(made.totals.rows[0][9].text(), "10") << "tables to plan";
}

}  // namespace
}  // namespace impinge::lab

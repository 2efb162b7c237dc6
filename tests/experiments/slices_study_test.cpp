// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: facing directions have the gap of the hip; each stage stands beside the truth and the one before
// it; a stage that changes nothing adds nothing; finer scans err less.
#include "19_slices_to_surface/slices_study.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "hip/hip_presets.hpp"

namespace impinge::lab {
namespace {

Hip small_hip() {
  HipParameters parameters = hip_preset("normal");
  parameters.wall_thickness = 5.0;
  parameters.shaft_length = 0.0;
  parameters.fossa_depth = 0.0;
  return make_hip(parameters, 1200);
}

SlicesOptions coarse() {
  SlicesOptions options;
  options.grid = {1.5, 1.5, 2.0};
  options.faces = 800;
  options.precision_deg = 4.0;
  return options;
}

TEST(FacingGaps, AreTheJointSpaceAwayFromTheRim) {
  const FacingGaps facing = facing_gaps(small_hip(), 120);
  ASSERT_GT(facing.directions.size(), 25U);
  ASSERT_LT(facing.directions.size(), 80U) << "about half of the sphere has no socket";
  // Faces lie within their spheres; the neck is farther away.
  for (const double gap : facing.gap) EXPECT_TRUE(gap > 4.0 && gap < 8.0) << gap;
}

TEST(SlicesToSurface, AddsStageByStage) {
  const Hip hip = small_hip();
  const FacingGaps truth = facing_gaps(hip, 120);
  SlicesOptions options = coarse();
  options.levels.noise = 0.0;
  const SlicesResult result = slices_to_surface(hip, truth, options);
  ASSERT_EQ(result.stages.size(), 5U);
  EXPECT_EQ(result.stages[0].stage, "slices");
  EXPECT_EQ(result.stages[0].added_rms_mm, result.stages[0].rms_mm) << "the stage before is the truth";
  EXPECT_EQ(result.stages[1].added_rms_mm, 0.0) << "no noise";
  EXPECT_EQ(result.stages[1].rms_mm, result.stages[0].rms_mm);
  EXPECT_GT(result.stages[2].added_rms_mm, 0.0);
  EXPECT_LE(result.stages[2].ball_faces, 800U);
  EXPECT_LE(result.ball.faces.size(), 800U);
  EXPECT_GT(result.stages[0].ball_faces, 800U);
  for (const StageError& stage : result.stages) {
    EXPECT_LE(std::abs(stage.mean_mm), stage.rms_mm);
    EXPECT_LE(stage.rms_mm, stage.largest_mm);
    EXPECT_LT(stage.rms_mm, 0.5);
  }
  EXPECT_LT(result.centre.norm(), 1.0);
}

TEST(SlicesToSurface, ErrsLessWithFinerSlicesAndLessNoise) {
  const Hip hip = small_hip();
  const FacingGaps truth = facing_gaps(hip, 120);
  const SlicesOptions options = coarse();
  SlicesOptions thick = options;
  thick.grid.slice = 6.0;
  const auto fine = slices_to_surface(hip, truth, options).stages;
  EXPECT_GT(fine[1].added_rms_mm, 0.0) << "noise";
  EXPECT_LT(fine[0].rms_mm, slices_to_surface(hip, truth, thick).stages[0].rms_mm);
}

}  // namespace
}  // namespace impinge::lab

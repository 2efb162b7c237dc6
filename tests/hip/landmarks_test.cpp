// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: motion_of_rotation() undoes joint_rotation(); a body and a femur that were turned come back to
// neutral.
#include "hip/landmarks.hpp"

#include <random>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace impinge {
namespace {

TEST(Landmarks, AMotionComesBackFromItsRotation) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> wide(-179.0, 179.0);
  std::uniform_real_distribution<double> narrow(-89.0, 89.0);
  for (const Side side : {Side::left, Side::right}) {
    for (int k = 0; k < 1000; ++k) {
      const Motion motion{wide(random), narrow(random), wide(random)};
      const Motion found = motion_of_rotation(joint_rotation(motion, side), side);
      EXPECT_NEAR(found.flexion, motion.flexion, 1e-9);
      EXPECT_NEAR(found.abduction, motion.abduction, 1e-9);
      EXPECT_NEAR(found.internal_rotation, motion.internal_rotation, 1e-9);
    }
  }
}

// Of a person who stands straight, about the hip of that side.
Landmarks standing(Side side) {
  const double lateral = side == Side::right ? 1.0 : -1.0;
  const double middle = -85.0 * lateral;
  Landmarks marks;
  marks.asis_right = {middle + 120.0, 45.0, 80.0};
  marks.asis_left = {middle - 120.0, 45.0, 80.0};
  marks.pubic_tubercle_right = {middle + 25.0, 45.0, -15.0};
  marks.pubic_tubercle_left = {middle - 25.0, 45.0, -15.0};
  marks.epicondyle_medial = {-40.0 * lateral, 5.0, -400.0};
  marks.epicondyle_lateral = {40.0 * lateral, -5.0, -400.0};
  return marks;
}

TEST(Landmarks, FramesAreUprightOfWhoStandsStraight) {
  for (const Side side : {Side::left, Side::right}) {
    const AnatomicalFrames frames =
        anatomical_frames(standing(side), Vec3::Zero(), side, input_to_joint("RAS"));
    EXPECT_LT((frames.pelvis - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_NEAR(frames.pelvic_tilt_deg, 0.0, 1e-12);
    // The epicondyles are turned by atan(1 / 8) outwards: the lateral one lies behind.
    EXPECT_NEAR(frames.scanned->internal_rotation, -std::atan2(5.0, 40.0) / kDegree, 1e-9);
    EXPECT_NEAR(frames.scanned->flexion, 0.0, 1e-9);
  }
}

TEST(Landmarks, ATurnOfTheWholeBodyTurnsBothFrames) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> small(-25.0, 25.0);
  for (int k = 0; k < 200; ++k) {
    const Side side = k % 2 == 0 ? Side::left : Side::right;
    Eigen::Matrix3d body = Eigen::Matrix3d::Identity();
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())})
      body = Eigen::AngleAxisd(small(random) * kDegree, axis) * body;
    const Vec3 centre(small(random), small(random), 900.0);
    const Motion pose{small(random), small(random), small(random)};
    Landmarks marks = standing(side);
    marks.epicondyle_medial->y() = marks.epicondyle_lateral->y() = 0.0;
    for (auto at : {&Landmarks::epicondyle_medial, &Landmarks::epicondyle_lateral})
      marks.*at = joint_rotation(pose, side) * *(marks.*at);
    for (auto at :
         {&Landmarks::asis_right, &Landmarks::asis_left, &Landmarks::pubic_tubercle_right,
          &Landmarks::pubic_tubercle_left, &Landmarks::epicondyle_medial, &Landmarks::epicondyle_lateral})
      marks.*at = Vec3(body * *(marks.*at) + centre);
    const AnatomicalFrames frames = anatomical_frames(marks, centre, side, input_to_joint("RAS"));
    EXPECT_LT((frames.pelvis - body.transpose()).norm(), 1e-9);
    EXPECT_NEAR(frames.scanned->flexion, pose.flexion, 1e-9);
    EXPECT_NEAR(frames.scanned->abduction, pose.abduction, 1e-9);
    EXPECT_NEAR(frames.scanned->internal_rotation, pose.internal_rotation, 1e-9);
  }
}

TEST(Landmarks, WithoutEpicondylesThereIsNoFemur) {
  Landmarks marks = standing(Side::left);
  marks.epicondyle_medial.reset();
  EXPECT_THROW(anatomical_frames(marks, Vec3::Zero(), Side::left, input_to_joint("RAS")),
               std::invalid_argument);
  marks.epicondyle_lateral.reset();
  EXPECT_FALSE(anatomical_frames(marks, Vec3::Zero(), std::nullopt, input_to_joint("RAS")).femur);
}

}  // namespace
}  // namespace impinge

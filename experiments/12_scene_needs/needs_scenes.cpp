// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>

#include "12_scene_needs/needs_study.hpp"

namespace impinge::lab {
namespace {

constexpr double kOnePose = 30.0;  // degrees
constexpr double kFarthest = 90.0;
constexpr double kStep = 10.0;  // between the poses of a motion
constexpr double kFineStep = 1.0;
constexpr double kAccuracy = 0.05;  // mm

Pose turned(const Vec3& axis, double degrees) {
  return {Eigen::AngleAxisd(degrees * kDegree, axis).toRotationMatrix(), Vec3::Zero()};
}

std::vector<Pose> there_and_back(const Vec3& axis, double step) {
  std::vector<Pose> motion;
  const auto steps = static_cast<int>(kFarthest / step);
  for (int k = 0; k <= steps; ++k) motion.push_back(turned(axis, step * k));
  for (int k = steps; k-- > 0;) motion.push_back(turned(axis, step * k));
  return motion;
}

}  // namespace

std::vector<NeedsScene> scenes_of(const std::string& name, const BallSocketPair& joint, const Vec3& axis) {
  const auto shared = std::make_shared<const BallSocketPair>(joint);
  SceneNeeds pose;
  pose.poses = {turned(axis, kOnePose)};
  SceneNeeds smallest = pose;
  smallest.question = Question::first_contact;
  SceneNeeds touch;
  touch.question = Question::touch;
  touch.poses = there_and_back(axis, kStep);
  SceneNeeds accurate;
  accurate.poses = there_and_back(axis, kFineStep);
  accurate.accuracy_mm = kAccuracy;
  return {{name + " all gaps", shared, pose},
          {name + " smallest gap", shared, smallest},
          {name + " touch in a motion", shared, touch},
          {name + " gaps in a motion", shared, accurate}};
}

}  // namespace impinge::lab

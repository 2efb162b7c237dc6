// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_error_against_time/contact_motions.hpp"

#include <algorithm>
#include <optional>
#include <random>

#include <Eigen/Geometry>

#include "methods/pose_set.hpp"
#include "sphere/infinity.hpp"
#include "sphere/uniform_directions.hpp"

namespace impinge::lab {
namespace {

constexpr double kLargestTurn = 1.0;  // radians
constexpr double kLongestPush = 8.0;  // mm
constexpr int kHalvings = 30;
constexpr int kTries = 10000;

double smallest_gap(const CulledJoint& joint, const Pose& pose) {
  const auto least = joint.least_gap(pose);
  return least ? least->gap_mm : kInfinity;
}

// Pushed along the way until the gap is `wanted`; none where it is less from the beginning, or never.
std::optional<Pose> pushed(const CulledJoint& joint, Pose pose, const Vec3& way, double wanted) {
  const auto gap_at = [&](double push) {
    pose.translation = push * way;
    return smallest_gap(joint, pose);
  };
  if (gap_at(0.0) <= wanted || gap_at(kLongestPush) > wanted) return std::nullopt;
  double before = 0.0;
  double after = kLongestPush;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (before + after);
    (gap_at(middle) > wanted ? before : after) = middle;
  }
  pose.translation = before * way;
  return pose;
}

// All of a motion, or nothing where a gap is not within the limits.
std::vector<Pose> turned_on(const CulledJoint& joint, const MotionGap& gap, const Pose& first,
                            const Vec3& axis) {
  std::vector<Pose> poses;
  for (std::size_t k = 0; k < kMotionPoses; ++k) {
    Pose pose = first;
    pose.rotation =
        Eigen::AngleAxisd(static_cast<double>(k) * kMotionStepDeg * kDegree, axis).toRotationMatrix() *
        first.rotation;
    const double least = smallest_gap(joint, pose);
    if (!(least >= gap.least_mm && least <= gap.most_mm)) return {};
    poses.push_back(pose);
  }
  return poses;
}

}  // namespace

std::vector<Pose> contact_motions(const CulledJoint& joint, const MotionGap& gap, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const Vec3 inwards = socket_axis(joint.meshes().socket);
  std::vector<Pose> poses;
  for (int k = 0; k < kTries && poses.size() < kMotions * kMotionPoses; ++k) {
    Pose pose;
    pose.rotation =
        Eigen::AngleAxisd(kLargestTurn * uniform(random), uniform_direction(random)).toRotationMatrix();
    Vec3 way = uniform_direction(random);
    way -= 2.0 * std::min(0.0, way.dot(inwards)) * inwards;
    const double wanted = gap.from_mm + (gap.to_mm - gap.from_mm) * uniform(random);
    const Vec3 axis = uniform_direction(random);
    const auto first = pushed(joint, pose, way, wanted);
    if (!first) continue;
    const auto motion = turned_on(joint, gap, *first, axis);
    poses.insert(poses.end(), motion.begin(), motion.end());
  }
  if (poses.size() < kMotions * kMotionPoses) poses.clear();
  return poses;
}

}  // namespace impinge::lab

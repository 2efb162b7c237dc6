// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <stdexcept>

#include <Eigen/Geometry>

#include "10_error_against_time/contact.hpp"
#include "methods/pose_set.hpp"
#include "reference/exact_radius.hpp"
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

// Pushes the ball until the gap is `wanted`; none if the gap is smaller from the start, or always larger.
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

// All poses of a motion; empty if a gap leaves the limits.
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

// A table of another joint is wrong nearly everywhere. A correct one may be off by more than a millimetre
// next to steep faces of a coarse mesh, and has no answer at the rim.
constexpr double kNear = 1.0;       // mm
constexpr double kLeastNear = 0.9;  // of the vertices that face the other surface

// How far off the gaps of one pose are.
struct Misfit {
  double largest = 0.0;   // error, mm
  std::size_t faced = 0;  // vertices that meet the other surface
  std::size_t near = 0;   // of these, answered and near the exact gap
};

void add_misfit(Misfit& misfit, const std::vector<float>& gaps, const std::vector<double>& exact) {
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (std::isnan(exact[i])) continue;
    ++misfit.faced;
    if (std::isnan(gaps[i])) continue;
    const double error = std::abs(static_cast<double>(gaps[i]) - exact[i]);
    if (error < kNear) ++misfit.near;
    misfit.largest = std::max(misfit.largest, error);
  }
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

bool any_impinged(const CulledJoint& joint, const Pose& pose) {
  return std::ranges::any_of(kSurfaces, [&](Surface scanned) {
    return std::ranges::any_of(mesh_of(joint.meshes(), scanned).vertices, [&](const Vec3& x) {
      return joint.exactly_impinged(scanned, to_other(scanned, pose, x));
    });
  });
}

ExactGaps exact_gaps(const BallSocketPair& pair, const Pose& pose) {
  const auto of = [&](Surface scanned) {
    std::vector<Vec3> moved;
    for (const Vec3& v : mesh_of(pair, scanned).vertices) moved.push_back(to_other(scanned, pose, v));
    const Surface asked = other(scanned);
    std::vector<double> gaps = exact_radii(mesh_of(pair, asked), {moved, facing_layer(asked), {}});
    for (std::size_t i = 0; i < gaps.size(); ++i) gaps[i] = signed_gap(scanned, gaps[i], moved[i].norm());
    return gaps;
  };
  return {of(Surface::ball), of(Surface::socket)};
}

double own_difference(const CulledJoint& joint, const ExactGaps& exact, const Pose& pose) {
  double largest = 0.0;
  for (const Surface scanned : kSurfaces) {
    const std::vector<Vec3>& vertices = mesh_of(joint.meshes(), scanned).vertices;
    const std::vector<double>& gaps = scanned == Surface::ball ? exact.ball : exact.socket;
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      const double off = std::abs(joint.gap(scanned, to_other(scanned, pose, vertices[i])) - gaps[i]);
      if (off > largest) largest = off;  // a NaN is not larger
    }
  }
  return largest;
}

double gap_error(const MadeContact& made, const ExactGaps& exact, const Pose& pose) {
  const JointGaps& gaps = made.query->gaps(pose);
  Misfit misfit;
  add_misfit(misfit, gaps.ball, exact.ball);
  add_misfit(misfit, gaps.socket, exact.socket);
  if (static_cast<double>(misfit.near) < kLeastNear * static_cast<double>(misfit.faced)) {
    throw std::runtime_error(made.method.name + ": only " + std::to_string(misfit.near) + " of " +
                             std::to_string(misfit.faced) +
                             " gaps are near the exact ones: its time means nothing until that is resolved");
  }
  return misfit.largest;
}

}  // namespace impinge::lab

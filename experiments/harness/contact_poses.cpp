// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/contact_poses.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Geometry>

#include "gap/exact_side.hpp"
#include "sphere/uniform_directions.hpp"

namespace impinge::lab {
namespace {

constexpr int kBisections = 24;

PosePath random_path(const SurfaceOverlay& joint, const ContactOptions& options, std::mt19937_64& random) {
  PosePath path;
  path.axis = uniform_direction(random);
  path.to_turn = options.turn * uniform(random);
  if (joint.impinged(path.at(1.0)) && !joint.impinged(path.at(0.0))) return path;  // the turn is the path
  path.from_turn = path.to_turn;
  path.shift = options.shift * uniform_direction(random);
  return path;
}

}  // namespace

Pose PosePath::at(double share) const {
  const double turn = from_turn + share * (to_turn - from_turn);
  return {Eigen::AngleAxisd(turn, axis).toRotationMatrix(), share * shift};
}

double path_length(const PosePath& path) {
  return path.shift.norm() + kArm * std::abs(path.to_turn - path.from_turn);
}

std::optional<double> first_contact(const PosePath& path, const std::function<bool(const Pose&)>& impinged) {
  if (impinged(path.at(0.0)) || !impinged(path.at(1.0))) return std::nullopt;
  double free = 0.0;
  double contact = 1.0;
  for (int k = 0; k < kBisections; ++k) {
    const double middle = 0.5 * (free + contact);
    (impinged(path.at(middle)) ? contact : free) = middle;
  }
  return contact;
}

std::vector<ContactPose> contact_poses(const SurfaceOverlay& joint, const ContactOptions& options) {
  std::mt19937_64 random(options.seed);
  std::vector<ContactPose> poses;
  poses.reserve(options.count);
  ContactPose pose;
  while (poses.size() < options.count) {
    if (poses.size() % kPosesPerPath == 0) {
      pose.path = random_path(joint, options, random);
      pose.contact = first_contact(pose.path, [&joint](const Pose& at) { return joint.impinged(at); });
    }
    double share = uniform(random);
    if (pose.contact && poses.size() % 4 != 0) {
      const double off = std::pow(10.0, -5.0 + 4.5 * uniform(random)) / path_length(pose.path);
      share = std::clamp(*pose.contact + (uniform(random) < 0.5 ? -off : off), 0.0, 1.0);
    }
    pose.pose = pose.path.at(share);
    poses.push_back(pose);
  }
  return poses;
}

bool vertices_impinged(const SurfaceOverlay& joint, const Pose& pose) {
  return std::ranges::any_of(joint.ball().vertices,
                             [&](const Vec3& x) {
                               return exactly_impinged(Surface::ball, joint.faces(Surface::socket),
                                                       to_socket(pose, x));
                             }) ||
         std::ranges::any_of(joint.socket().vertices, [&](const Vec3& y) {
           return exactly_impinged(Surface::socket, joint.faces(Surface::ball), to_ball(pose, y));
         });
}

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/pose_travel.hpp"

#include <algorithm>

#include "files/formatted.hpp"
#include "hip/arrangement.hpp"

namespace impinge {
namespace {

constexpr double kNoTranslation = 1e-6;  // mm

double radius_of(const Joint& joint) {
  if (joint.fit) return joint.fit->radius;
  return facing(joint.ball.main(), joint.socket.main()).ball_radius;
}

// What all poses that are too far away have in common.
struct Far {
  std::size_t count = 0;
  std::size_t first = 0;
  double most = 0.0;  // mm
  bool metres = true;
  bool centimetres = true;
  bool about_origin = true;

  void add(std::size_t place, const Pose& pose, const Vec3& centre, double radius) {
    const double travel = pose.translation.norm();
    if (travel <= radius) return;
    if (count++ == 0) first = place;
    most = std::max(most, travel);
    const Vec3 given = pose.translation + centre - pose.rotation * centre;  // x' = R x + given
    const auto fits = [&](double unit) { return (pose.translation + (unit - 1.0) * given).norm() <= radius; };
    metres = metres && fits(1e3);
    centimetres = centimetres && fits(10.0);
    about_origin = about_origin && given.norm() <= kNoTranslation;
  }
  std::string advice(const Vec3& c) const {
    if (metres || centimetres)
      return std::string("their translations look like ") + (metres ? "metres" : "centimetres") + "; give mm";
    if (about_origin)
      return formatted(
          "they turn about the origin of the frame; add the translation c - R c, c = %.3f,%.3f,%.3f", c.x(),
          c.y(), c.z());
    return "give poses of the ball relative to the socket, in the frame of the meshes and mm: of two poses "
           "in "
           "a room, the inverse of the socket's times that of the ball";
  }
};

}  // namespace

std::string doubtful_travel(const Joint& joint, std::size_t poses,
                            const std::function<Pose(std::size_t)>& pose_at, std::size_t first) {
  double most = 0.0;
  for (std::size_t k = 0; k < poses; ++k) most = std::max(most, pose_at(k).translation.norm());
  if (most <= kNoTranslation) return {};
  const double radius = radius_of(joint);
  Far far;
  for (std::size_t k = 0; k < poses; ++k) far.add(k, pose_at(k), joint.centre, radius);
  if (far.count == 0) return {};
  return formatted(
             "%zu of %zu poses, first pose %zu, move the centre of the ball as far as %.3g mm from that "
             "of the socket, and its radius is %.3g mm: ",
             far.count, poses, far.first + first, far.most, radius) +
         far.advice(joint.centre);
}

}  // namespace impinge

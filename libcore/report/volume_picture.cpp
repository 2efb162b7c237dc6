// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/volume_picture.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "hip/motion.hpp"
#include "joint/volume_map.hpp"
#include "report/map_picture.hpp"

namespace impinge {
namespace {

constexpr double kDarkest = 120.0;  // degrees of rotation

// Shade for so many degrees of internal and external rotation together.
std::string shade(double range) { return free_shade(std::min(range, kDarkest) / kDarkest); }

// Colour of a pose.
std::string colour(const MotionVolume& volume, const Motion& pose, Side side) {
  const auto [state, range] = map_square(volume, pose, side);
  if (state == CellState::free) return shade(range);
  return std::string(state == CellState::blocked ? kMapBlocked : kMapUndecided);
}

void add_ranges(MapPicture& picture) {
  for (int k = 0; k <= 4; ++k)
    picture.key(2, 22 * k, shade(30.0 * k), std::to_string(30 * k) + (k == 4 ? "+" : ""));
}

// How many of the 360 degrees of rotation about the femur's axis are free.
int free_rotations(const MotionVolume& volume, Motion pose, Side side) {
  int free = 0;
  for (int rotation = -180; rotation < 180; rotation += kMapStep) {
    pose.internal_rotation = rotation + 0.5 * kMapStep;
    const Eigen::Quaterniond q(joint_rotation(pose, side));
    free += volume.at({q.w(), q.x(), q.y(), q.z()}).state == CellState::free ? kMapStep : 0;
  }
  return free;
}

}  // namespace

std::string volume_picture(const MotionVolume& volume, Side side) {
  MapPicture picture({.left = kMapExtension,
                      .right = kMapFlexion,
                      .bottom = -kMapAbduction,
                      .top = kMapAbduction,
                      .beside = "abduction, degrees"});
  for (int abduction = kMapAbduction - kMapStep; abduction >= -kMapAbduction; abduction -= kMapStep) {
    for (int flexion = kMapExtension; flexion < kMapFlexion; flexion += kMapStep) {
      const Motion pose{flexion + 0.5 * kMapStep, abduction + 0.5 * kMapStep, 0.0};
      picture.square(flexion, abduction, kMapStep, colour(volume, pose, side));
    }
  }
  picture.name_angles();
  picture.mark(0.0, 0.0, true);
  picture.words(0, "flexion, degrees; the ring is the neutral pose");
  picture.words(1, "rotation without contact, internal and external together, degrees:");
  add_ranges(picture);
  picture.key(2, 117, kMapBlocked, "blocked");
  picture.key(2, 153, kMapUndecided, "undecided");
  return picture.finished();
}

std::string mobility_picture(const MotionVolume& volume, Side side) {
  MapPicture picture({.left = -180.0,
                      .right = 180.0,
                      .bottom = -90.0,
                      .top = 90.0,
                      .step_across = 90,
                      .step_up = 45,
                      .beside = "abduction, degrees"});
  for (int abduction = -90; abduction < 90; abduction += kMapStep) {
    const double middle = abduction + 0.5 * kMapStep;
    const double cosine = std::cos(middle * kDegree);
    picture.rectangle(-180.0 * cosine, abduction, 360.0 * cosine, kMapStep, kMapBlocked);
    for (int flexion = -180; flexion < 180; flexion += kMapStep) {
      const int free = free_rotations(volume, {flexion + 0.5 * kMapStep, middle, 0.0}, side);
      if (free > 0) picture.rectangle(flexion * cosine, abduction, kMapStep * cosine, kMapStep, shade(free));
    }
  }
  picture.name_angles();
  picture.mark(0.0, 0.0, true);
  picture.words(0, "flexion times the cosine of the abduction, degrees; the ring is the neutral pose");
  picture.words(1, "certainly without contact, of all 360 degrees of rotation about the femur's axis:");
  add_ranges(picture);
  picture.key(2, 117, kMapBlocked, "none");
  return picture.finished();
}

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/volume_picture.hpp"

#include <algorithm>

#include "joint/volume_map.hpp"
#include "report/map_picture.hpp"

namespace impinge {
namespace {

constexpr double kDarkest = 120.0;  // degrees of rotation

// Of so many degrees of rotation, internal and external together.
std::string shade(double range) { return free_shade(std::min(range, kDarkest) / kDarkest); }

// Colour of the pose.
std::string colour(const MotionVolume& volume, const Motion& pose, Side side) {
  const auto [state, range] = map_square(volume, pose, side);
  if (state == CellState::free) return shade(range);
  return std::string(state == CellState::blocked ? kMapBlocked : kMapUndecided);
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
  for (int k = 0; k <= 4; ++k)
    picture.key(2, 22 * k, shade(30.0 * k), std::to_string(30 * k) + (k == 4 ? "+" : ""));
  picture.key(2, 117, kMapBlocked, "blocked");
  picture.key(2, 153, kMapUndecided, "undecided");
  return picture.finished();
}

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Which rotations are free if the joint has play? The ball may be shifted by any d with |d| <= r: a point x
/// of it goes to R x + d. Theorem 15 (play).
///
///   free     with one shift nothing touches in any of the rotations
///   blocked  with every shift something touches in every one of them
///
/// To shift the ball by d is to shift the socket by -d, so that one shift is tested as no shift is. A vertex
/// that is beyond all faces that it may meet, or a point within an inner ball, is so in a half-space of
/// shifts too: n . d >= least. If half-spaces hold all shifts up to r, all are blocked. If not, the shift
/// that is farthest from them is tried next; where it touches, it yields more of them.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "sphere/direction.hpp"

namespace impinge {

/// A half-space of shifts d of the ball, mm: those with normal . d >= least, in the socket's frame.
struct ShiftHalfSpace {
  Vec3 normal;  // unit; or zero, where all shifts are alike
  double least;
};

struct FarthestShift {
  Vec3 shift = Vec3::Zero();  // mm, the shift that is about the farthest from all of them
  /// mm: for every shift, normal . d - least >= inside for some half-space. Above 0, they hold all shifts.
  double inside;
};
/// Of all shifts up to play_mm long. `inside` is proven, up to rounding; a larger one may hold.
FarthestShift farthest_from(std::span<const ShiftHalfSpace> half_spaces, double play_mm);

/// A shift of the ball along the socket's axes, in parts of the play / kShiftSteps.
using ShiftSteps = std::array<std::int16_t, 3>;
inline constexpr double kShiftSteps = 32767.0;
/// In mm, and about the nearest one in steps; neither is longer than the play.
Vec3 shift_of(const ShiftSteps& steps, double play_mm);
ShiftSteps steps_of(const Vec3& shift, double play_mm);

}  // namespace impinge

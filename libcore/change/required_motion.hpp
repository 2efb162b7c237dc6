// SPDX-License-Identifier: GPL-3.0-or-later
// Motions that a joint is to reach, as the path that a surgeon moves the leg along, in pieces of which every
// pose is known to within an angle.
//
// The path of a motion begins in the pose of the scan and changes one angle after the other, in the order of
// joint_rotation(): flexion (or extension) first, at that flexion abduction (or adduction), and there
// rotation. All poses on the way belong to it, and no others: not the box of all smaller angles.
//
// A leg of the path is a turn R(a) = outer R(axis, a) inner. A turn by d about any axis moves no direction by
// more than |d|, so that every R(a) with a in [from, to] brings each direction to within (to - from) / 2 of
// where R((from + to) / 2) brings it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hip/motion.hpp"
#include "rotations/cell_test.hpp"

namespace impinge {

/// A leg of the path: one angle grows and the others stay.
struct RequiredLeg {
  JointTurn turn;            // joint frame
  Motion start;              // degrees, where the leg begins
  std::string_view growing;  // one of motion_names()
  double largest_deg = 0.0;  // the turn runs from 0, the start, to this angle
};

/// The legs of the path to a motion; none for the pose of the scan. std::invalid_argument as for
/// joint_rotation().
std::vector<RequiredLeg> required_legs(const Motion& motion, std::optional<Side> side);

/// Those of several motions, one path after the other.
std::vector<RequiredLeg> required_legs(std::span<const Motion> motions, std::optional<Side> side);

/// A leg in words: "internal_rotation from 0 to 30 degrees at flexion 90".
std::string describe(const RequiredLeg& leg);

/// A part of a leg, angles in degrees.
struct LegPart {
  std::size_t leg = 0;    // place among the legs
  double from_deg = 0.0;  // of the angle that grows
  double to_deg = 0.0;    // of the angle that grows
};

/// When parts are not halved any more for the sake of a cap of directions.
inline constexpr double kCertainEnough = 2e-3;  // mm: what is uncertain is no longer than this
inline constexpr double kNarrowPart = 0.35;     // of the cap's angle: a part that is no wider stays
inline constexpr double kLeastPart = 1e-8;      // radians: narrower parts are all rounding

/// Rotations that hold every pose of the part, rounded outwards.
RotationBall poses_of(const RequiredLeg& leg, const LegPart& part);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Motions that a joint is required to reach, as the paths on which a surgeon moves the leg.
//
// A path begins in the pose of the scan and changes one angle after the other, in the order of
// joint_rotation(): flexion or extension first, then abduction or adduction, then rotation. All poses on the
// path are required, and no others: not the box of all smaller angles.
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

/// The legs of the path to a motion; none for the pose of the scan. Throws as joint_rotation() does.
std::vector<RequiredLeg> required_legs(const Motion& motion, std::optional<Side> side);

/// The legs of several motions, one path after the other.
std::vector<RequiredLeg> required_legs(std::span<const Motion> motions, std::optional<Side> side);

/// A leg in words: "internal_rotation from 0 to 30 degrees at flexion 90".
std::string describe(const RequiredLeg& leg);

/// A part of a leg, angles in degrees.
struct LegPart {
  std::size_t leg = 0;    // index of the leg
  double from_deg = 0.0;  // where the growing angle begins
  double to_deg = 0.0;    // where it ends
};

/// For a question about a cap of directions, parts of legs are halved until one of these holds.
inline constexpr double kCertainEnough = 2e-3;  // mm: no more than this is uncertain
inline constexpr double kNarrowPart = 0.35;  // the part turns by no more than this share of the cap's radius
inline constexpr double kLeastPart = 1e-8;   // radians: narrower parts are rounding only

/// Rotations that hold every pose of the part, rounded outwards: half of its angle about the middle pose.
RotationBall poses_of(const RequiredLeg& leg, const LegPart& part);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Motions of a joint in which the smallest gap is known, to time contact in: how long an answer takes depends
// on it.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "contact/culled_joint.hpp"

namespace impinge::lab {

// The ball is turned by up to a radian about any axis and pushed towards the socket, in a direction up to a
// quarter turn from its axis (methods/pose_set.hpp), until the smallest gap is as wanted; then it turns on,
// the gap staying within the limits.
struct MotionGap {
  std::string_view name;  // in the results
  double from_mm;         // smallest gap in the first pose of a motion, drawn evenly
  double to_mm;
  double least_mm;  // in every pose
  double most_mm;
};
// From free to touching.
inline constexpr std::array kMotionGaps{MotionGap{"over 2 mm", 2.1, 2.5, 2.0, 3.0},
                                        MotionGap{"0.5 mm", 0.45, 0.55, 0.4, 0.6},
                                        MotionGap{"touching", -0.3, 0.05, -0.5, 0.1}};

inline constexpr std::size_t kMotions = 16;      // of each case
inline constexpr std::size_t kMotionPoses = 16;  // of each, one after the other
inline constexpr double kMotionStepDeg = 0.5;    // from one to the next, about any axis

// Poses of all motions, one motion after the other; none where the joint has not so many.
std::vector<Pose> contact_motions(const CulledJoint& joint, const MotionGap& gap, std::uint64_t seed);

}  // namespace impinge::lab

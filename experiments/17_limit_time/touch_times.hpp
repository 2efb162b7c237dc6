// SPDX-License-Identifier: GPL-3.0-or-later
// Time of one pose: do the bones touch? Ours as the program asks it, beside others' trees of the whole bones.
#pragma once

#include <cstddef>
#include <cstdint>

#include "17_limit_time/limit_times.hpp"

namespace impinge::lab {

// How much is timed.
struct TouchPlan {
  std::size_t poses = 200;  // of each kind that touch, and that are clear
  int rounds = 9;
  std::uint64_t seed = 0;
};

LimitTimes empty_touch_times();
std::vector<Column> touch_time_keys();  // joint, faces, poses, state, method

// Adds the rows of a joint: any rotation, rotations of up to 60 degrees, and poses within two degrees of the
// limit of a named motion. What touches is decided by CGAL's exact signs, and std::runtime_error is thrown
// where ours says that they are clear, or that surfaces meet, against it.
void add_touch_times(const TurnedJoint& joint, const TouchPlan& plan, const TimingOptions& timing,
                     LimitTimes& found, Progress& progress);

}  // namespace impinge::lab

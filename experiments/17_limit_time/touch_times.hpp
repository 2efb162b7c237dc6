// SPDX-License-Identifier: GPL-3.0-or-later
// Time of one pose: do the bones touch? Our program's test is compared with others' trees of the whole bones.
#pragma once

#include <cstddef>
#include <cstdint>

#include "17_limit_time/limit_times.hpp"

namespace impinge::lab {

// How much is timed.
struct TouchPlan {
  std::size_t poses = 200;  // touching and clear poses of each kind
  int rounds = 9;
  std::uint64_t seed = 0;
};

LimitTimes empty_touch_times();
std::vector<Column> touch_time_keys();  // joint, faces, poses, state, method

// Adds the rows of a joint: any rotation, rotations of up to 60 degrees, and poses within two degrees of the
// limit of a named motion. CGAL's exact signs decide what touches. Throws std::runtime_error if our test
// calls such bones clear, or says that surfaces meet that do not.
void add_touch_times(const TurnedJoint& joint, const TouchPlan& plan, const TimingOptions& timing,
                     LimitTimes& found, Progress& progress);

}  // namespace impinge::lab

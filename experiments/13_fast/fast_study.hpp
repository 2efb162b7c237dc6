// SPDX-License-Identifier: GPL-3.0-or-later
// How fast all gaps of a pose are found, beside Embree and beside the least that a look-up can do, and how
// far off the answers are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "13_fast/fast_table.hpp"
#include "harness/timing.hpp"

namespace impinge::lab {

// One generated pair, of so many triangles a model, and the tables that are tried on it.
struct FastJoint {
  std::size_t triangles = 0;  // of each surface
  GapSizes sizes;             // of the tables
  bool thorough = false;      // are its methods asked cold, too, and with every instruction set?
};

// What is tried and how often.
struct FastOptions {
  std::vector<FastJoint> joints;  // one after the other
  int rounds = 15;                // of each case
  double ray_tests = 4e8;         // triangles that the truth of the errors may look at, for each surface
  TimingOptions timing;           // of the rounds
  std::uint64_t seed = 0;         // of the probes
};

// The result and its times.
struct FastTables {
  Table table;                                     // as fast_table() makes it
  TimingRun timing;                                // of all cases
  std::map<std::string, std::string> labels = {};  // of the methods
};

inline constexpr int kMotionTurns = 24;  // poses of the motion, after which it begins again
// Flexion by 5 degrees a turn, to 115 degrees, the ball a little off the centre.
Pose motion_pose(int turn);

// Errors first. std::runtime_error for a method that is too far off to be timed.
FastTables fast_tables(const FastOptions& options, Progress& progress);

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// What baselines.csv says: bytes, times, lost triangles and wrong answers of every method of Section 3.6.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "18_baselines/baseline_points.hpp"
#include "18_baselines/baseline_poses.hpp"
#include "harness/timing.hpp"
#include "methods/baseline.hpp"

namespace impinge::lab {

// One joint, and what is tried on it.
struct BaselineJoint {
  std::string name;           // in the results
  BallSocketPair meshes;      // centre frames, mm
  BaselineSizes sizes;        // of the methods
  BaselineWays ways;          // of the poses near contact
  std::size_t points = 2000;  // vertices of each surface that are asked, at most
};

// How often everything is timed.
struct BaselineOptions {
  int build_rounds = 3;  // of building a method
  int pose_rounds = 9;   // of asking it
  double slow_s = 3.0;   // building that takes longer is timed once
};

// The result and its times.
struct BaselineTables {
  Table table;                                     // baselines.csv
  TimingRun timing;                                // of building and asking
  std::map<std::string, std::string> labels = {};  // of the methods
};

/// The answers of a method about the points beside the exact ones; nothing for one that gives none. Throws
/// std::runtime_error for an answer that breaks what is proven.
BaselineAnswers ask(const BaselineCase& method, const BaselinePoints& points);

// Columns of the table, and keys of the timed cases.
std::vector<Column> baseline_columns();
std::vector<Column> baseline_keys();  // joint, method, setting and what is timed

// Builds, checks and judges all methods on all joints, then times them in one interleaved run.
BaselineTables baseline_tables(const std::vector<BaselineJoint>& joints, const BaselineOptions& options,
                               Progress& progress);

}  // namespace impinge::lab

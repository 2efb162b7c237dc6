// SPDX-License-Identifier: GPL-3.0-or-later
// Timing the methods of the thesis' Tables 4 and 9 on several joints.
#pragma once

#include <memory>
#include <vector>

#include "harness/driver.hpp"
#include "harness/timing.hpp"
#include "methods/pose_set.hpp"

namespace impinge::lab {

// A joint with all methods that say whether a pose touches, the poses they are timed over and the oracle that
// each of them must agree with first. One row of the table for each method.
struct BenchmarkJoint {
  std::vector<Cell> key;                       // key cells after the method: numbers of triangles, say
  double pairs = 0.0;                          // of triangles
  std::shared_ptr<const BallSocketPair> pair;  // that the methods refer to
  std::vector<NamedPose> poses;                // that all of them are asked
  TouchCase oracle;                            // exact predicates
  std::vector<TouchCase> methods;
};

// Meshes in their centre frames, mm; the precision, degrees, is that of all tables.
BenchmarkJoint make_benchmark_joint(const BallSocketPair& pair, std::vector<Cell> key, double precision_deg);

// What of the slowest method is measured, and what scaled.
struct DetectionOptions {
  // Pairs of triangles up to which `pairwise` is measured; beyond, its time is scaled by the pairs from that
  // of the joint before.
  double most_pairs = 0.0;
  // Pairs up to which `pairwise` gets all rounds; beyond, three.
  double most_pairs_often = 2e7;
};

// Times all methods on all joints, in one interleaved run, the mean over the poses each, and writes the
// result with its samples. The columns of the table are filled in here. std::runtime_error, and nothing is
// timed, where a method does not agree with the oracle.
void write_benchmark(DriverRun& driver, Result result, const std::vector<Column>& key_columns,
                     const std::vector<BenchmarkJoint>& joints, const DetectionOptions& options);

}  // namespace impinge::lab

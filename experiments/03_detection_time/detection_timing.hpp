// SPDX-License-Identifier: GPL-3.0-or-later
// Times the methods of the thesis' Tables 4 and 9 on several joints.
#pragma once

#include <memory>
#include <vector>

#include "harness/driver.hpp"
#include "harness/timing.hpp"
#include "methods/pose_set.hpp"

namespace impinge::lab {

// A joint with all methods that say whether a pose touches, the poses that are timed, and the oracle with
// which each method must agree first. Each method makes one row of the table.
struct BenchmarkJoint {
  std::vector<Cell> key;                       // key cells after the method, such as numbers of triangles
  double pairs = 0.0;                          // number of pairs of triangles
  std::shared_ptr<const BallSocketPair> pair;  // the methods refer to it
  std::vector<NamedPose> poses;                // the same for all methods
  TouchCase oracle;                            // exact predicates
  std::vector<TouchCase> methods;
};

// Meshes in their centre frames, mm; all tables have this precision, degrees.
BenchmarkJoint make_benchmark_joint(const BallSocketPair& pair, std::vector<Cell> key, double precision_deg);

// How much of the slowest method is measured and how much is scaled.
struct DetectionOptions {
  // Pairs of triangles up to which `pairwise` is measured. Beyond, its time on the joint before is scaled by
  // the number of pairs.
  double most_pairs = 0.0;
  // Pairs up to which `pairwise` gets all rounds; beyond, it gets three.
  double most_pairs_often = 2e7;
};

// Times all methods on all joints in one interleaved run, each as the mean over the poses, and writes the
// result with its samples. It fills in the columns of the table. If a method does not agree with the oracle
// it throws std::runtime_error and times nothing.
void write_benchmark(DriverRun& driver, Result result, const std::vector<Column>& key_columns,
                     const std::vector<BenchmarkJoint>& joints, const DetectionOptions& options);

}  // namespace impinge::lab

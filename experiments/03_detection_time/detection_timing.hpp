// SPDX-License-Identifier: GPL-3.0-or-later
// Timing the methods of detection on several joints: the form that Table 4 and the real joints share.
#pragma once

#include <memory>
#include <vector>

#include "harness/driver.hpp"
#include "harness/timing.hpp"
#include "methods/pose_set.hpp"

namespace impinge::lab {

/// One joint with the methods of the thesis' Tables 4 and 9, the poses they are timed over and the oracle
/// that each of them must agree with first.
struct DetectionBenchmark {
  std::shared_ptr<const BallSocketPair> pair;  // that the methods refer to
  std::vector<NamedPose> poses;                // that all of them are asked
  TouchCase oracle;                            // exact predicates
  std::vector<TouchCase> methods;              // all that say whether a pose touches
};

/// Meshes in their centre frames, mm; the precision is that of tables.
DetectionBenchmark make_detection_benchmark(const BallSocketPair& pair, double precision_deg);

// One row of the table for each method.
struct BenchmarkJoint {
  std::vector<Cell> before;  // key cells before the method: the subject, say
  std::vector<Cell> after;   // key cells after it: numbers of triangles
  double pairs = 0.0;        // of triangles
  DetectionBenchmark bench;  // methods, poses and oracle
};

// Meshes in their centre frames; the precision, degrees, is that of all tables.
BenchmarkJoint make_benchmark_joint(std::vector<Cell> before, const BallSocketPair& pair,
                                    std::vector<Cell> after, double precision_deg);

// The mean over the poses, after the method agreed with the oracle in all of them. All that is referred to
// must outlive the case.
TimedCase benchmark_case(std::vector<Cell> key, const TouchCase& method, const DetectionBenchmark& bench);

// What of the slowest method is measured, and what scaled.
struct DetectionOptions {
  // Pairs of triangles up to which `pairwise` is measured; beyond, its time is scaled by the pairs.
  double most_pairs = 0.0;
  // Pairs up to which `pairwise` gets all rounds; beyond, three.
  double most_pairs_often = 2e7;
  // The timing of one pair, to scale from until a measured joint yields it.
  Timing pair = {};
};

// Times all methods on all joints, in one interleaved run, and writes the result with its samples. The
// columns of the table are filled in here. Returns the timing of one pair on the last joint that was measured
// pairwise.
Timing write_benchmark(DriverRun& driver, Result result, const std::vector<Column>& key_columns,
                       const std::vector<BenchmarkJoint>& joints, const DetectionOptions& options);

}  // namespace impinge::lab

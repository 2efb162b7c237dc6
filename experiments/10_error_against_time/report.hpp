// SPDX-License-Identifier: GPL-3.0-or-later
// A vertex asked alone, on one scene after the other: errors first, with every bound checked, then the costs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "10_error_against_time/costs.hpp"
#include "10_error_against_time/errors.hpp"
#include "files/csv.hpp"

namespace impinge::lab {

// What runs, where errors are measured, and how costs are timed.
struct BenchmarkOptions {
  PointSizes sizes;             // of the methods
  ProbeOptions radial;          // of methods that answer radii
  ProbeOptions euclidean;       // of methods that answer distances
  AscentOptions ascent;         // from the worst probes
  std::uint64_t seed = 0;       // of motions
  BenchmarkTiming timing;       // of the costs of a vertex asked alone
  BenchmarkTiming gap_timing;   // of those of all gaps of a pose
  BenchmarkTiming pose_timing;  // of touch, of smallest gaps, and of the first contact of a motion
};

// What small machines and short runs can do, and the whole of it.
BenchmarkOptions quick_benchmark();
BenchmarkOptions full_benchmark();  // the latter

// The results, row by row.
struct BenchmarkTables {
  QuestionTable main;  // error_against_time.csv; keys as in cost_keys()
  Table spread;        // error_against_time_spread.csv
};
BenchmarkTables make_benchmark_tables();  // with their columns, and no row
std::vector<Column> cost_keys();          // scene, method, setting and which cost

// All methods on the scene: adds their rows. Throws BoundViolated.
void run_benchmark(const BenchmarkScene& scene, const BenchmarkOptions& options, BenchmarkTables& tables,
                   Progress& progress);

}  // namespace impinge::lab

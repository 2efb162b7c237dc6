// SPDX-License-Identifier: GPL-3.0-or-later
// The benchmark on one scene after the other: errors first, with every bound checked, then the costs; and the
// tables that they fill.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "10_error_against_time/costs.hpp"
#include "10_error_against_time/errors.hpp"
#include "files/csv.hpp"

namespace impinge::lab {

// What runs, where errors are measured, and how costs are timed.
struct BenchmarkOptions {
  PointSizes sizes;            // of the methods
  ProbeOptions radial;         // of methods that answer radii
  ProbeOptions euclidean;      // of methods that answer distances
  AscentOptions ascent;        // from the worst probes
  BenchmarkTiming timing;      // of the costs of a vertex asked alone
  BenchmarkTiming gap_timing;  // of those of all gaps of a pose
};

// What small machines and short runs can do, and the whole of it.
BenchmarkOptions quick_benchmark();
BenchmarkOptions full_benchmark();  // the latter

// The results, row by row, and the times behind them.
struct BenchmarkTables {
  Table main;                                      // error_against_time.csv
  Table spread;                                    // error_against_time_spread.csv
  TimingRun timing;                                // of all scenes; keys as in cost_keys()
  std::map<std::string, std::string> labels = {};  // of the methods
};
BenchmarkTables make_benchmark_tables();  // with their columns, and no row
std::vector<Column> cost_keys();          // scene, method, setting and which cost

// All methods on the scene: adds their rows. Throws BoundViolated.
void run_benchmark(const BenchmarkScene& scene, const BenchmarkOptions& options, BenchmarkTables& tables,
                   Progress& progress);

}  // namespace impinge::lab

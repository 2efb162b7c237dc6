// SPDX-License-Identifier: GPL-3.0-or-later
// The benchmark on one scene after the other: errors first, with every bound checked, then the costs; and the
// tables that they fill.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "10_error_against_time/errors.hpp"
#include "10_error_against_time/timing.hpp"
#include "files/csv.hpp"

namespace impinge::lab {

// What runs, where errors are measured, and how costs are timed.
struct BenchmarkOptions {
  PointSizes sizes;               // of the methods
  ProbeOptions radial;            // of methods that answer radii
  ProbeOptions euclidean;         // of methods that answer distances
  AscentOptions ascent;           // from the worst probes
  BenchmarkTimingOptions timing;  // of the costs
};

// What small machines and short runs can do, and the whole of it.
BenchmarkOptions quick_benchmark();
BenchmarkOptions full_benchmark();  // the latter

// The three results, row by row.
struct BenchmarkTables {
  Table main;                                      // error_against_time.csv
  Table spread;                                    // error_against_time_spread.csv
  Table samples;                                   // error_against_time_samples.csv
  std::map<std::string, std::string> labels = {};  // of the methods
};
BenchmarkTables make_benchmark_tables();  // with their columns, and no row

// A bound that does not hold: nothing that was measured can be trusted until that is resolved.
class BoundViolated : public std::runtime_error {
 public:
  explicit BoundViolated(const Violation& violation);        // what() gives its text()
  const Violation& violation() const { return violation_; }  // the one that ended the benchmark

 private:
  Violation violation_;
};

// All methods on the scene: adds their rows. Throws BoundViolated.
void run_benchmark(const BenchmarkScene& scene, const BenchmarkOptions& options, BenchmarkTables& tables,
                   Progress& progress);

}  // namespace impinge::lab

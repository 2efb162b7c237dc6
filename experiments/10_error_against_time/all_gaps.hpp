// SPDX-License-Identifier: GPL-3.0-or-later
// All gaps of a pose: how far off they are by every method and how fast they are found, beside the least that
// a look-up can do.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "10_error_against_time/report.hpp"
#include "files/csv.hpp"
#include "methods/gaps.hpp"

namespace impinge::lab {

// What is tried on a scene.
struct GapPlan {
  GapSizes sizes;         // of the tables
  bool thorough = false;  // are its methods asked cold, too, and with every instruction set?
};

// The result, row by row, and the times behind it.
struct GapTables {
  Table table;                                     // all_gaps.csv
  TimingRun timing;                                // of all scenes; keys as in gap_keys()
  std::map<std::string, std::string> labels = {};  // of the methods
};
GapTables make_gap_tables();  // with its columns, and no row

// scene, triangles, direction, method, setting, storage, instruction_set, threads, state.
std::vector<Column> gap_keys();

// Both directions: adds their rows. std::runtime_error for a method whose errors are too large for its time
// to mean anything, BoundViolated for a bound that does not hold.
void run_all_gaps(const BenchmarkScene& scene, const GapPlan& plan, const BenchmarkOptions& options,
                  GapTables& tables, Progress& progress);

}  // namespace impinge::lab

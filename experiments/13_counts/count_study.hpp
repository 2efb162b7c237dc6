// SPDX-License-Identifier: GPL-3.0-or-later
// Instructions and misses of a cache of the ways to find all gaps of a pose, and to tell whether it touches.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "files/csv.hpp"
#include "harness/event_counts.hpp"

namespace impinge::lab {

// What is counted.
struct CountOptions {
  std::size_t triangles = 12000;  // of each of the two models
  int poses = 1;                  // of a motion, all of them in each run
};

// The program that is counted: every way, a run of it each, with every instruction set that valgrind knows.
void run_counted(const CountOptions& options);

/// What a reader calls the methods that are counted.
std::map<std::string, std::string> counted_labels();

// The counts of that program, a row a way, each event over the vertices or poses of the run.
Table count_table(const std::vector<EventCounts>& counts);

}  // namespace impinge::lab

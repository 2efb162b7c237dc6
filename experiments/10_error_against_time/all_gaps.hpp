// SPDX-License-Identifier: GPL-3.0-or-later
// All gaps of a pose: how far off they are by every method and how fast they are found, beside the least that
// a look-up can do.
#pragma once

#include <string>
#include <vector>

#include "10_error_against_time/report.hpp"
#include "methods/gaps.hpp"

namespace impinge::lab {

// What is tried on a scene.
struct GapPlan {
  GapSizes sizes;         // of the tables
  bool thorough = false;  // are its methods asked cold, too, and with every instruction set?
};

QuestionTable make_gap_table();  // all_gaps.csv

// scene, triangles, direction, method, setting, storage, instruction_set, threads, state.
std::vector<Column> gap_keys();

// Both directions: adds their rows. std::runtime_error for a method whose errors are too large for its time
// to mean anything.
void run_all_gaps(const BenchmarkScene& scene, const GapPlan& plan, const BenchmarkOptions& options,
                  QuestionTable& found, Progress& progress);

}  // namespace impinge::lab

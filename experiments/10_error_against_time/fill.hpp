// SPDX-License-Identifier: GPL-3.0-or-later
// How long the tables of a joint take to fill: drawn at once, by the library's rasteriser, and by Embree.
#pragma once

#include <cstddef>
#include <vector>

#include "10_error_against_time/costs.hpp"

namespace impinge::lab {

// What is filled.
struct FillPlan {
  std::vector<std::size_t> triangles;  // of each model
  std::vector<std::size_t> cells;      // along an edge of the cube
};

// method, storage, memory, threads, triangles, cells, entries (of both tables).
std::vector<Column> fill_keys();

// fill.csv: one run fills the tables of ball and socket. std::runtime_error for a method whose tables are not
// right, before any is timed.
QuestionTable fill_tables(const FillPlan& plan, const BenchmarkTiming& timing, Progress& progress);

}  // namespace impinge::lab

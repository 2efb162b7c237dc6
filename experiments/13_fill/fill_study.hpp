// SPDX-License-Identifier: GPL-3.0-or-later
// How long the tables of a joint take to fill: drawn at once, by the library's rasteriser, and by Embree.
#pragma once

#include <cstddef>
#include <vector>

#include "files/csv.hpp"
#include "harness/timing.hpp"
#include "methods/fill.hpp"

namespace impinge::lab {

// What is filled and how often.
struct FillOptions {
  std::vector<std::size_t> triangles;  // of each model
  std::vector<std::size_t> cells;      // along an edge of the cube
  int rounds = 9;                      // of each case
  TimingOptions timing;                // of the rounds
};

// method, storage, memory, threads, triangles, cells, entries (of both tables).
std::vector<Column> fill_keys();

// One run fills the tables of ball and socket. std::runtime_error for a way whose tables are not right,
// before any is timed.
TimingRun time_filling(const FillOptions& options, const std::vector<FillCase>& methods, Progress& progress);

}  // namespace impinge::lab

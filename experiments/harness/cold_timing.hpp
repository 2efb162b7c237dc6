// SPDX-License-Identifier: GPL-3.0-or-later
// The time of work whose memory is in no cache: before each sample, which is timed alone, a block of memory
// that is larger than the caches is written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "harness/timing.hpp"

namespace impinge::lab {

// One thing to be timed.
struct ColdCase {
  std::vector<Cell> key;      // method and settings
  std::function<void()> run;  // once untimed, then once a round
  double units = 1.0;         // pieces of work in one run
};

// How often, and what is written in between.
struct ColdOptions {
  int rounds = 15;                                  // samples of each case
  std::size_t flush_bytes = std::size_t{96} << 20;  // written before each sample
  std::uint64_t seed = 0;                           // of the order within a round
};

// In the order of the cases.
std::vector<Timing> time_cold(const std::vector<ColdCase>& cases, const ColdOptions& options);

}  // namespace impinge::lab

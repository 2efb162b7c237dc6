// SPDX-License-Identifier: GPL-3.0-or-later
// How long it takes to say whether a joint touches, and how far it is from that: culled, pose by pose or
// along a motion, by scans of all vertices, and by FCL.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "files/csv.hpp"
#include "harness/timing.hpp"

namespace impinge::lab {

// What is timed and how often.
struct ContactOptionsTimed {
  std::vector<std::size_t> triangles;  // of each model, ever more
  int rounds = 15;                     // of each case
  std::uint64_t seed = 0;              // of the motions
  TimingOptions timing;                // of the rounds
};

// The result and its times.
struct ContactTables {
  Table table;                                     // a row a case
  TimingRun timing;                                // of all cases
  std::map<std::string, std::string> labels = {};  // of the methods
};

// method, gap_case, triangles.
std::vector<Column> contact_keys();

// Every culled answer that is timed is compared with the exact test of all vertices first, or one of several
// where there are many. std::runtime_error where one differs.
ContactTables contact_tables(const ContactOptionsTimed& options, Progress& progress);

}  // namespace impinge::lab

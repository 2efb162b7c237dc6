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
#include "methods/benchmark_scene.hpp"

namespace impinge::lab {

// What is timed and how often.
struct ContactOptionsTimed {
  int rounds = 15;         // of each case
  std::uint64_t seed = 0;  // of the motions
  TimingOptions timing;    // of the rounds
};

// The result and its times.
struct ContactTables {
  Table table;                                     // a row a case
  TimingRun timing;                                // of all scenes
  std::map<std::string, std::string> labels = {};  // of the methods
};

ContactTables make_contact_tables();  // with its columns, and no row

// scene, method, gap_case, triangles.
std::vector<Column> contact_keys();

// Every culled answer that is timed is compared with the exact test of all vertices first, or one of several
// where there are many. std::runtime_error where one differs. Adds the rows of the scene; a gap case that it
// has no motions of is left out, and the progress says so.
void run_contact(const BenchmarkScene& scene, const ContactOptionsTimed& options, ContactTables& tables,
                 Progress& progress);

}  // namespace impinge::lab

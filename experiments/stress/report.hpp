// SPDX-License-Identifier: GPL-3.0-or-later
// What the families come to, as tables.
#pragma once

#include <string>
#include <vector>

#include "files/csv.hpp"
#include "harness/progress.hpp"
#include "stress/family.hpp"

namespace impinge::lab {

// The three tables of the results, row by row.
struct StabilityTables {
  Table main;      // stability.csv
  Table detail;    // stability_detail.csv
  Table families;  // stability_families.csv
  // One line for each failure of ours outside of what it refuses.
  std::vector<std::string> broken;
};
StabilityTables make_stability_tables();  // with their columns, and no row

// Runs the family and adds its rows. Throws std::logic_error for a family of fewer than 5 magnitudes.
void run_family(const StabilityFamily& family, const StabilityRun& run, StabilityTables& tables);

// Of all families, one after the other.
StabilityTables run_stability(const StabilityRun& run, Progress& progress);

}  // namespace impinge::lab

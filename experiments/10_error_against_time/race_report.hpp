// SPDX-License-Identifier: GPL-3.0-or-later
// The race on one scene after the other: errors first, with every bound checked, then the costs; and the
// tables that they fill.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "10_error_against_time/race_errors.hpp"
#include "10_error_against_time/race_methods.hpp"
#include "10_error_against_time/race_timing.hpp"
#include "files/csv.hpp"

namespace impinge::lab {

// What runs, where errors are measured, and how costs are timed.
struct RaceOptions {
  TableRace tables;                     // of every scheme
  std::vector<std::size_t> grid_nodes;  // a side
  ProbeOptions radial;                  // of methods that answer radii
  ProbeOptions euclidean;               // of methods that answer distances
  AscentOptions ascent;                 // from the worst probes
  RaceTimingOptions timing;             // of the costs
};

// What small machines and short runs can do, and the whole of it.
RaceOptions quick_race();
RaceOptions full_race();  // the latter

// The three results, row by row.
struct RaceTables {
  Table main;     // error_against_time.csv
  Table spread;   // error_against_time_spread.csv
  Table samples;  // error_against_time_samples.csv
};
RaceTables make_race_tables();  // with their columns, and no row

// A bound that does not hold: nothing that was measured can be trusted until that is resolved.
class BoundViolated : public std::runtime_error {
 public:
  explicit BoundViolated(const Violation& violation);        // what() gives its text()
  const Violation& violation() const { return violation_; }  // the one that ended the race

 private:
  Violation violation_;
};

// All methods on the scene: adds their rows. Throws BoundViolated.
void run_race(const RaceScene& scene, const RaceOptions& options, RaceTables& tables, Progress& progress);

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// Claims of the thesis that it never showed (Chapter 6), one function and one file each.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "files/csv.hpp"
#include "harness/timing.hpp"

namespace impinge::lab {

// One row of the table: a number that speaks for or against a claim.
struct Claim {
  std::string claim;     // of the thesis, in words
  std::string setting;   // such as the precision
  std::string quantity;  // what the number is
  double value = 0.0;    // the number
  std::string unit;      // of it
};

struct ClaimsStudy {
  std::vector<Claim> rows;       // what was measured without timing
  std::vector<TimedCase> cases;  // key: claim, setting, quantity; they own what they work on
};

// Sizes of what is tried.
struct ClaimsOptions {
  std::size_t faces = 12000;                                 // of each surface
  double precision_deg = 0.5;                                // of the tables
  std::vector<double> collision_precisions{1.0, 0.5, 0.25};  // degrees
  std::vector<double> caps{5.0, 10.0, 20.0, 45.0};           // degrees, of the part that moves
  int rounds = 9;                                            // of each timed case
};

// A cap of the ball moves in and out again: the table is brought up to date in place, or filled anew. The two
// must be the same, bit for bit, else std::runtime_error.
void add_deforming(ClaimsStudy& study, const ClaimsOptions& options);

// A layer of cartilage is pressed through the bone under it. Found pairs of triangles beside those that cross
// exactly.
void add_self_collision(ClaimsStudy& study, const ClaimsOptions& options);

// Where cartilage is, beside a distance that is added to the radius of the bone.
void add_layers(ClaimsStudy& study, const ClaimsOptions& options);

// The result and its times.
struct ClaimsTables {
  Table table;       // rows and times
  TimingRun timing;  // of the cases
};
std::vector<Column> claims_keys();  // claim, setting, quantity
// Times the cases and puts them below the rows.
ClaimsTables claims_tables(const ClaimsStudy& study, Progress& progress);

}  // namespace impinge::lab

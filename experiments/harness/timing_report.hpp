// SPDX-License-Identifier: GPL-3.0-or-later
// How timings enter the results: a table of medians, the raw samples and a record of the protocol.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "files/csv.hpp"
#include "harness/driver.hpp"
#include "harness/timing.hpp"

namespace impinge::lab {

// The given columns for the keys of the cases, then median_ms, iqr_ms, rounds, extrapolated, inconclusive and
// repeats.
std::vector<Column> timing_columns(std::vector<Column> key_columns);

// Cells of such a row for a timing that is not extrapolated.
std::vector<Cell> timing_cells(const Timing& timing);

// A table of these columns, one row a case, with one more column median_ns: the median in nanoseconds.
Table medians_in_ns(std::vector<Column> key_columns, const TimingRun& run, const std::string& unit);

// Cells of an extrapolated row: its key, and the timing of a smaller measurement, already scaled.
std::vector<Cell> extrapolated_cells(std::vector<Cell> key, const Timing& scaled);

// One row a round: the key of the case under the given columns, then round (from 1) and ms (a unit of work).
Table samples_table(std::vector<Column> key_columns, const TimingRun& run);

// For the sidecar: protocol, batch of each case, control case with its samples and ratio, repeated and
// inconclusive cases.
nlohmann::json timing_record(const TimingRun& run);

// Writes the result with its record of timing, then the samples behind it as NAME_samples, and warns of every
// case that is inconclusive.
void write_timed(DriverRun& driver, Result result, const std::vector<Column>& key_columns,
                 const TimingRun& run);

}  // namespace impinge::lab

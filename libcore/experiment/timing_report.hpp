// SPDX-License-Identifier: GPL-3.0-or-later
// What a measurement leaves in the results: its raw samples and the record of its protocol.
#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "experiment/csv.hpp"
#include "experiment/timing.hpp"

namespace impinge {

// One row a round: the key of the case under the given columns, then round (from 1) and ms (a unit of work).
Table samples_table(std::vector<Column> key_columns, const TimingRun& run);

// For the sidecar: protocol, batch of each case, control case with its samples and ratio, inconclusive cases.
nlohmann::json timing_record(const TimingRun& run);

// One warning a case that is inconclusive, and one for a control that is off.
void warn_if_inconclusive(const TimingRun& run, Progress& progress);

}  // namespace impinge

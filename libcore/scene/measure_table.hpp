// SPDX-License-Identifier: GPL-3.0-or-later
// The measures of a joint, as rows of measures.csv.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "files/csv.hpp"
#include "joint/measures.hpp"
#include "scene/options.hpp"

namespace impinge {

/// measures.csv without rows: joint, measure, value, uncertainty, unit, state (hip/measure_list.hpp), and
/// what is published of the measure (hip/published_measures.hpp).
Table measure_table();
/// Adds the measures of a joint.
void add_measure_rows(const std::string& joint, const std::vector<MeasureRow>& measures, Table& table);

/// The contents of summary.json.
nlohmann::json measures_summary(const SceneOptions& options, const SessionJoint& joint,
                                const std::vector<MeasureRow>& measures);
/// A line of text for each measure.
std::string describe_measures(const std::vector<MeasureRow>& measures);

}  // namespace impinge

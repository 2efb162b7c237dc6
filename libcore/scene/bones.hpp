// SPDX-License-Identifier: GPL-3.0-or-later
// Asks one question of every joint in a folder, answered in one table.
#pragma once

#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

#include "scene/options.hpp"

namespace impinge {

/// Asks each joint of options.bones (joint/joint_folder.hpp), with the centre, side and axes of its
/// description where the options give none, and writes into options.out
///   limits.csv     of the question limit (scene/limit_table.hpp)
///   measures.csv   of the question measures (scene/measure_table.hpp)
///   joints.csv     of the other questions: a row for each joint, with the numbers of its summary
///   JOINT/         of the questions volume, resection and orientation: the files of each joint
/// A joint that cannot be used is left out: summary.json and a line on `log` say why; `log` also gets the
/// progress. std::runtime_error if no joint is left, FileError if a file cannot be written.
///
/// Returns the contents of summary.json.
nlohmann::json answer_bones(const SceneOptions& options, std::ostream& log);

/// The summary as text for a terminal.
std::string describe_bones(const SceneOptions& options, const nlohmann::json& summary);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Many poses of a joint, answered one by one into poses.csv.
#pragma once

#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

#include "joint/pose_list.hpp"
#include "joint/session.hpp"
#include "scene/options.hpp"

namespace impinge {

/// Answers each pose (joint/pose_series.hpp) and writes a row for it to options.out / "poses.csv":
/// pose (from 1), touch, certified (yes: the verdict is exact for this pose; a matrix stands for its nearest
/// rotation), smallest_gap_mm with its surface, vertex, clock and bound_mm (proven, on the error of that
/// vertex's gap), and the angles as given; empty for what was not asked for or does not exist. A row that is
/// not tracked keeps its number, and has "untracked" for touch and nothing else.
/// With options.areas there are four more columns before the angles: mm^2 of ball and socket with a gap of 0
/// or less (bone_*_mm2), and of the cartilage's thickness or less (cartilage_*_mm2).
///
/// Rows go to "poses-KEY.part" first, which is renamed to poses.csv when complete. KEY is a hash of all that
/// was asked, files included. A later run of the same question goes on from the rows that an interrupted run
/// left; the bytes are those of one run. FileError if a file cannot be written.
///
/// Returns the contents of summary.json. A line of progress every few seconds goes to `log`, and one on
/// matrices that no joint can follow (hip/pose_travel.hpp).
nlohmann::json answer_poses(const SceneOptions& options, const SessionJoint& joint, std::ostream& log);

/// How many poses are answered, for --explain.
inline constexpr const char* kWayOfPoses =
    "a tree of caps over both surfaces, made once: touch and the smallest gap ask the few vertices and faces "
    "that no cap decides";

/// The summary as text for a terminal.
std::string describe_poses(const nlohmann::json& summary);

}  // namespace impinge

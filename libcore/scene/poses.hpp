// SPDX-License-Identifier: GPL-3.0-or-later
// Many poses of a joint, answered one by one into poses.csv.
#pragma once

#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

#include "scene/options.hpp"
#include "scene/pose_list.hpp"
#include "session/session.hpp"

namespace impinge {

/// Answers each pose (session/pose_series.hpp) and writes a row for it to options.out / "poses.csv":
/// pose (from 1), touch, certified (yes: the verdict is exact for this pose, a matrix being its nearest
/// rotation), smallest_gap_mm with its surface, vertex, clock and bound_mm (proven, on the error of that
/// vertex's gap), and the angles as given; empty for what was not asked for or is not there.
/// With options.areas four columns more before the angles: mm^2 of ball and socket with a gap of 0 or less
/// (bone_*_mm2), and of the cartilage's thickness or less (cartilage_*_mm2).
///
/// Rows go to "poses-KEY.part" first, where they can be read; it becomes poses.csv when it is whole. KEY
/// stands for all that was asked, files included. What an interrupted run left of the same question is kept,
/// and the rest is added: the bytes are those of one run. FileError where a file cannot be written.
///
/// Returns the contents of summary.json. A line of progress every few seconds goes to `log`.
nlohmann::json answer_poses(const SceneOptions& options, const SessionJoint& joint, std::ostream& log);

/// How they are answered, for --explain.
inline constexpr const char* kWayOfPoses =
    "a tree of caps over both surfaces, made once: touch and the smallest gap ask the few vertices and faces "
    "that no cap decides";

/// The summary for a reader at a terminal.
std::string describe_poses(const nlohmann::json& summary);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Output of the program `scene` for a pose with all gaps: ball.ply, socket.ply, gaps.csv, distances.csv,
// summary.json, and a few lines of text.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "joint/measurement.hpp"
#include "scene/joint.hpp"

namespace impinge {

/// The contents of summary.json. Lengths in mm, areas in mm^2, angles in degrees, times in ms; null where
/// there is no value.
nlohmann::json summary(const SceneOptions& options, const SessionJoint& joint,
                       const Measurement& measurement);

/// Writes the files that options.outputs asks for into options.out, all of them or none (file_set.hpp).
/// Positions are those of the pose, in the input frame. FileError if a file cannot be written.
void write_scene(const SceneOptions& options, const SessionJoint& joint, const Measurement& measurement,
                 const nlohmann::json& summary);

/// The summary as text for a terminal.
std::string describe_scene(const SceneOptions& options, const SessionJoint& joint,
                           const Measurement& measurement);

}  // namespace impinge

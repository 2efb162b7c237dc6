// SPDX-License-Identifier: GPL-3.0-or-later
// What the program `scene` says of a pose with all gaps: ball.ply, socket.ply, gaps.csv, distances.csv,
// summary.json, and a few lines for the reader.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "scene/joint.hpp"
#include "session/measurement.hpp"

namespace impinge {

/// The contents of summary.json. Lengths in mm, areas in mm^2, angles in degrees, times in ms; null where
/// there is no value.
nlohmann::json summary(const SceneOptions& options, const SessionJoint& joint,
                       const Measurement& measurement);

/// Writes the files that options.outputs asks for into options.out, all of them or none (file_set.hpp): an
/// older set is kept where one cannot be written. Positions are those of the pose, in the input frame.
void write_scene(const SceneOptions& options, const SessionJoint& joint, const Measurement& measurement,
                 const nlohmann::json& summary);

/// The same for a reader at a terminal.
std::string describe_scene(const SceneOptions& options, const SessionJoint& joint,
                           const Measurement& measurement);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// What the program `scene` says of all rotations of a joint.
#pragma once

#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

#include "scene/options.hpp"
#include "session/session.hpp"

namespace impinge {

/// Refines the motion volume and writes to options.out
///   volume.csv   a row a cell: level, cell (its number), w, x, y, z (quaternion in its middle, the largest
///                coordinate 1: a rotation of the ball in the joint frame), radius_deg, share of all
///                rotations, state, reachable (yes: certainly without contact from the pose of the scan; no:
///                certainly not; else empty)
///   volume.svg   with a side: over flexion and abduction how far the ball may be rotated, as far as the
///                cells know
/// and returns the contents of volume.json. "volume-KEY.part" holds what was worked out until they are whole:
/// an interrupted run is taken up there and ends with the same bytes. A line of progress every few seconds
/// goes to `log`. FileError where a file cannot be written.
nlohmann::json write_volume(const SceneOptions& options, const SessionJoint& joint, std::ostream& log);

/// volume.json for a reader at a terminal.
std::string describe_volume(const nlohmann::json& found);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Output of the program `scene` for all rotations of a joint.
#pragma once

#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

#include "joint/session.hpp"
#include "scene/options.hpp"

namespace impinge {

/// Refines the motion volume and writes to options.out
///   volume.csv   a row a cell: level, cell (its number), w, x, y, z (quaternion of its middle, scaled to a
///                largest coordinate of 1: a rotation of the ball in the joint frame), radius_deg, share of
///                all rotations, state, reachable (yes: certainly without contact from the pose of the scan;
///                no: certainly not; else empty)
///   volume.svg   if the side is known: the picture of volume_picture.hpp
///   volume.json  the summary, which is returned
/// Until these are complete, "volume-KEY.part" holds what was worked out: a later run goes on from there and
/// ends with the same bytes. A line of progress every few seconds goes to `log`. FileError if a file cannot
/// be written.
nlohmann::json write_volume(const SceneOptions& options, const SessionJoint& joint, std::ostream& log);

/// volume.json as text for a terminal.
std::string describe_volume(const nlohmann::json& found);

}  // namespace impinge

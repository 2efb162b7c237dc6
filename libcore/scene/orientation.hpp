// SPDX-License-Identifier: GPL-3.0-or-later
// Output of the program `scene` on the orientations of the socket in which required motions are free:
// orientation.csv and orientation.json.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "joint/orient.hpp"
#include "scene/options.hpp"

namespace impinge {

/// The request that the options make.
OrientRequest orientation_request(const SceneOptions& options);

/// The contents of orientation.json: angles in degrees, areas of the map in square degrees, times in ms.
nlohmann::json orientation_summary(const SceneOptions& options, const SessionJoint& joint,
                                   const OrientAnswer& found, double milliseconds);

/// Writes orientation.json and orientation.csv into options.out, both or none. A row for each square of the
/// map: inclination_deg and anteversion_deg of its middle, half_width_deg, state (free, blocked, open,
/// unknown) and, where it is not free, motion: a part of the required motions that is not free there.
void write_orientation(const SceneOptions& options, const OrientAnswer& found, const nlohmann::json& summary);

/// The summary as text for a terminal.
std::string describe_orientation(const SceneOptions& options, const OrientAnswer& found);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Output of the program `scene` on the bone that has to go for required motions: resection.json and
// resected_ball.ply, or resected_socket.ply.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "joint/resect.hpp"
#include "scene/options.hpp"

namespace impinge {

/// How the required motions are understood.
inline constexpr const char* kWhichPath =
    "each required motion is its path from the pose of the scan, one angle after the other: flexion, "
    "abduction, "
    "rotation";

/// The request for a resection that the options make.
ResectRequest resection_request(const SceneOptions& options);

/// The contents of resection.json: volume (mm^3), area (mm^2) and depth (mm) as proven intervals, and each
/// leg of the required motions before and after; angles in degrees, times in ms. Of an open socket the volume
/// is null, and `volume_why` says why.
nlohmann::json resection_summary(const SceneOptions& options, const SessionJoint& joint,
                                 const ResectAnswer& found, double milliseconds);

/// Writes into options.out, all files or none: resection.json; resected_ball.ply or resected_socket.ply, the
/// bone that is left, in the input frame, with the `depth` of removed bone at each vertex (mm along its ray);
/// and, for a least cut, swept.csv, with parts of the ball's surface (input frame) and the radii there that
/// may have to go.
void write_resection(const SceneOptions& options, const ResectAnswer& found, const nlohmann::json& summary);

/// The summary as text for a terminal.
std::string describe_resection(const SceneOptions& options, const ResectAnswer& found);

}  // namespace impinge

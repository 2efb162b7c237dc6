// SPDX-License-Identifier: GPL-3.0-or-later
// What the program `scene` says of the bone that required motions would need gone: resection.json and
// resected_ball.ply.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "scene/options.hpp"
#include "session/resection.hpp"

namespace impinge {

/// In every output of a cut.
inline constexpr const char* kNoGuide =
    "Research software, not a medical device: nothing in this may guide the treatment of a patient.";

/// What the required motions are.
inline constexpr const char* kWhichPath =
    "each required motion is its path from the pose of the scan, one angle after the other: flexion, "
    "abduction, "
    "rotation";

/// What the options ask of a cut.
ResectionRequest resection_request(const SceneOptions& options);

/// The contents of resection.json: volume in mm^3, area in mm^2 and depth in mm between proven ends, and each
/// leg of the required motions before and after, angles in degrees, times in ms.
nlohmann::json resection_summary(const SceneOptions& options, const SessionJoint& joint,
                                 const ResectionAnswer& found, double milliseconds);

/// Writes resection.json and resected_ball.ply into options.out, both or none: the ball that is left, in the
/// input frame, with the `depth` of bone that is gone at each vertex, mm along its ray. With them, if there
/// is a least cut, swept.csv: parts of the ball's surface, in that frame, and the radii there that may have
/// to go.
void write_resection(const SceneOptions& options, const SessionJoint& joint, const ResectionAnswer& found,
                     const nlohmann::json& summary);

/// The same for a reader at a terminal.
std::string describe_resection(const SceneOptions& options, const ResectionAnswer& found);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Output of the program `scene` for the limit of a motion.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "joint/limits.hpp"
#include "scene/options.hpp"

namespace impinge {

/// The request for a limit that the options make.
LimitRequest limit_request(const SceneOptions& options);

/// The contents of summary.json for the motion options.limit, which grows from the pose. Brackets of the
/// angle
/// * at which the surfaces touch, about the centre of the ball and about that of a sphere fitted to the
///   socket (left out if no sphere fits);
/// * at which a gap falls to the cartilage's thickness, about the centre of the ball.
/// Each comes with what half a millimetre changes (limits/told_limit.hpp), and with the angle at which the
/// motion leaves the mesh of the ball. Angles in degrees, lengths in mm, times in ms.
nlohmann::json limit_summary(const SceneOptions& options, const SessionJoint& joint,
                             const LimitAnswers& found, double milliseconds);

/// The same as text for a terminal.
std::string describe_limits(const SceneOptions& options, const LimitAnswers& found);

/// Where the limit may be, such as "20.8 to 61.9 degrees".
std::string range_text(const CentreInterval& range);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// What the program `scene` says of the limit of a motion.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "scene/options.hpp"
#include "session/limits.hpp"

namespace impinge {

/// What the options ask of a limit.
LimitRequest limit_request(const SceneOptions& options);

/// The contents of summary.json: for options.limit, growing from the pose, the bracket of the angle at which
/// the surfaces touch, about the centre of the ball and about that of a sphere fitted to the socket
/// (equidistant; left out where no sphere fits), and at which a gap falls to the cartilage's thickness, about
/// the centre of the ball; each with what half a millimetre changes (motion/told_limit.hpp), and where the
/// mesh of the ball is left. Angles in degrees, lengths in mm, times in ms.
nlohmann::json limit_summary(const SceneOptions& options, const SessionJoint& joint,
                             const LimitAnswers& found, double milliseconds);

/// The same for a reader at a terminal.
std::string describe_limits(const SceneOptions& options, const LimitAnswers& found);

/// Which parts of the bones stop a motion, "greater trochanter and AIIS"; empty where the main surfaces do.
std::string parts_of(const LimitAnswer& answer);

}  // namespace impinge

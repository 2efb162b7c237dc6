// SPDX-License-Identifier: GPL-3.0-or-later
// What the program `scene` says of the limit of a motion.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "scene/joint.hpp"
#include "scene/options.hpp"

namespace impinge {

/// The contents of summary.json: for options.limit, growing from the pose, the bracket of the angle at which
/// the surfaces touch, about the centre of the ball and about that of a sphere fitted to the socket
/// (equidistant; left out where no sphere fits), and at which a gap falls to the cartilage's thickness, about
/// the centre of the ball; each with what half a millimetre changes (motion/told_limit.hpp), and where the
/// mesh of the ball is left. Angles in degrees, lengths in mm, times in ms.
nlohmann::json limit_summary(const SceneOptions& options, const Joint& joint);

/// The same for a reader at a terminal.
std::string describe_limits(const nlohmann::json& summary);

}  // namespace impinge

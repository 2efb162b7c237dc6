// SPDX-License-Identifier: GPL-3.0-or-later
// Output of the program `scene` for all rotations of a joint.
#pragma once

#include <ostream>

#include "command/question_command.hpp"
#include "joint/volume.hpp"
#include "scene/options.hpp"

namespace impinge {

Told tell_volume(Session& session, const VolumeRequest& request, const Work& work);  // command/volume.cpp

/// Writes volume.csv, volume.svg if the side is known, and volume.json to options.out. FileError if a file
/// cannot be written.
Told write_volume(const SceneOptions& options, Session& session, std::ostream& log);

}  // namespace impinge

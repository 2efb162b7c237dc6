// SPDX-License-Identifier: GPL-3.0-or-later
// A user's joint, from two files.
#pragma once

#include <string>

#include "scene/options.hpp"
#include "session/session.hpp"

namespace impinge {

/// Reads both meshes and puts them together (hip/joint.hpp), with the map of the cartilage if there is one,
/// by the axes that are given or that the headers say (mesh/declared_axes.hpp), and by landmarks in the
/// frames that these give. FileError for a file that cannot be used; otherwise as assemble_joint(), with the
/// names of the files.
Session load_joint(const SceneOptions& options);

/// What a reader must know of the frames that were not given by --axes alone; a line each.
std::string describe_frames(const SceneOptions& options, const Joint& joint);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// A user's joint, from two files.
#pragma once

#include "scene/options.hpp"
#include "session/session.hpp"

namespace impinge {

/// Reads both meshes and puts them together (hip/joint.hpp), with the map of the cartilage if there is one.
/// FileError for a file that cannot be used; otherwise as assemble_joint(), with the names of the files.
Session load_joint(const SceneOptions& options);

}  // namespace impinge

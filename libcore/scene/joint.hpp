// SPDX-License-Identifier: GPL-3.0-or-later
// A user's joint, from two files.
#pragma once

#include <string>

#include "joint/session.hpp"
#include "scene/options.hpp"

namespace impinge {

/// Reads both meshes and assembles the joint (hip/joint.hpp), with the cartilage map if there is one. Axes
/// are those given, else those of the headers (mesh/declared_axes.hpp); landmarks set the anatomical frames.
/// FileError for a file that cannot be used; otherwise throws as assemble_joint(), with the files' names.
Session load_joint(const SceneOptions& options);

/// A line for each whole bone: what of it was taken as the surface of the joint.
std::string describe_taken(const SceneOptions& options, const Joint& joint);

/// Lines on how the frames were found, where not by --axes alone.
std::string describe_frames(const SceneOptions& options, const Joint& joint);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Records what was asked, so that an answer can be reproduced.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "hip/joint.hpp"
#include "scene/options.hpp"

namespace impinge {

/// What every summary.json begins with: units, files, the centre of rotation (mm, input frame) and where it
/// is from, pose, side, axes, landmarks, question and its options, and the warnings about the joint. null for
/// what was not given.
nlohmann::json asked_json(const SceneOptions& options, const Joint& joint);

/// Adds to `found` what of a whole bone was taken as the surface of the joint, if the mesh is one.
void add_taken(const JointPart& part, nlohmann::json& found);

/// Adds to `found` the names of the parts that stop a motion (mesh/mesh_parts.hpp), as ball_part and
/// socket_part: null for the main surface, no key if the joint has no parts on that side.
void add_part_names(const Joint& joint, const std::string& ball, const std::string& socket,
                    nlohmann::json& found);

/// Hash (fnv1a(), 16 hexadecimal digits) of what an answer depends on: the bytes of meshes and landmark file,
/// asked_json() and `more`.
std::string asked_key(const SceneOptions& options, const Joint& joint, std::string_view more);

}  // namespace impinge

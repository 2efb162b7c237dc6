// SPDX-License-Identifier: GPL-3.0-or-later
// What was asked, so that whoever has the answer can ask again.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "hip/joint.hpp"
#include "scene/options.hpp"

namespace impinge {

/// What every summary.json begins with: units, files, the centre of rotation (mm, input frame) and where it
/// is from, pose, side, axes and question, what this question was asked with besides, and the warnings about
/// the joint. null for what was not given.
nlohmann::json asked_json(const SceneOptions& options, const Joint& joint);

/// Which parts of the bones stop something (mesh/mesh_parts.hpp), as ball_part and socket_part: null for the
/// main surface, left out where a joint has none.
void add_part_names(const Joint& joint, const std::string& ball, const std::string& socket,
                    nlohmann::json& found);

/// Hash of 64 bits of bytes that follow those of `start` (Fowler, Noll, Vo).
inline constexpr std::uint64_t kFnvStart = 0xcbf29ce484222325U;
std::uint64_t fnv1a(std::string_view bytes, std::uint64_t start = kFnvStart);

/// Names all that an answer hangs on, files, question and `more`: FNV-1a with 64 bits (Fowler, Noll, Vo).
std::string asked_key(const SceneOptions& options, const Joint& joint, std::string_view more);

}  // namespace impinge

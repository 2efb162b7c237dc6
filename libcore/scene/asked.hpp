// SPDX-License-Identifier: GPL-3.0-or-later
// What was asked, so that whoever has the answer can ask again.
#pragma once

#include <nlohmann/json.hpp>

#include "hip/joint.hpp"
#include "scene/options.hpp"

namespace impinge {

/// What every summary.json begins with: units, files, the centre of rotation (mm, input frame) and where it
/// is from, pose, side, axes and question, what this question was asked with besides, and the warnings about
/// the joint. null for what was not given.
nlohmann::json asked_json(const SceneOptions& options, const Joint& joint);

}  // namespace impinge

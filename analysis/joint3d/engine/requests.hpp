// SPDX-License-Identifier: GPL-3.0-or-later
// Requests of the page as the session takes them. std::invalid_argument, one line, for what is not there.
#pragma once

#include <array>
#include <string_view>

#include "joint/limits.hpp"
#include "joint/pose_answer.hpp"
#include "js_values.hpp"
#include "mesh/declared_axes.hpp"

namespace impinge {

HipParameters hip_request(const val& request);
JointInput meshes_request(const val& request);
std::optional<LandmarkBytes> landmarks_request(const val& request);
AxesChoice axes_request(const val& request);  // of meshes: as the page or the headers of their files say
TableSettings table_request(const val& request);
PoseRequest pose_request(const val& request);
LimitRequest limit_request(const val& request);
double step_request(const val& request);  // of a sweep, degrees

// In the order of Storage.
inline constexpr std::array<std::string_view, 3> kStorages{"double", "float", "uint16"};

}  // namespace impinge

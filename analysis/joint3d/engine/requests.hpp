// SPDX-License-Identifier: GPL-3.0-or-later
// Requests of the page as the session takes them. std::invalid_argument, one line, for what is not there.
#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "joint/limits.hpp"
#include "joint/pose_answer.hpp"
#include "js_values.hpp"
#include "mesh/declared_axes.hpp"

namespace impinge {

template <>
inline constexpr std::array<std::string_view, 3> words_of<Storage>{"double", "float", "uint16"};

template <>
inline constexpr std::tuple fields_of<TableSettings>{
    Field{"scheme", "", "of both tables", &TableSettings::scheme},
    // A page keeps no larger ones: 0.2 degrees are 1.2 million entries and more a table.
    Field{"precision_deg", "deg", "their spacing", &TableSettings::precision_deg, Range{.least = 0.2}},
    Field{"storage", "", "of their numbers", &TableSettings::storage}};

template <>
inline constexpr std::tuple fields_of<PoseRequest>{
    Field{"pose", "", "of the ball", &PoseRequest::motion},
    Field{"translation", "mm", "shift of the ball, frame of the meshes", &PoseRequest::translation},
    Field{"cartilage_mm", "mm", "thickness of both layers", &PoseRequest::cartilage_mm, kNotNegative}};

// The limits of one motion, which may begin at any pose, and the smallest gaps on the way.
struct SweepRequest : LimitsRequest {
  double step_deg = 1.0;

  static constexpr auto fields = std::tuple_cat(
      LimitsRequest::fields,
      std::tuple{Field{"step_deg", "deg", "of the way", &SweepRequest::step_deg, Range{.least = 0.1}}});
};

// A request that files/fields.hpp describes.
template <class Request>
Request described(const val& request) {
  Request asked;
  if (is_given(request)) read_request(json_from(request), asked);
  return asked;
}

HipParameters hip_request(const val& request);
JointInput meshes_request(const val& request);
std::optional<LandmarkBytes> landmarks_request(const val& request);
AxesChoice axes_request(const val& request);  // of meshes: as the page or the headers of their files say

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// The joint frame: which way of the input frame is the patient's right, front and top.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include <Eigen/Core>

#include "files/fields.hpp"

namespace impinge {

/// Side of the body: the patient's own left or right.
enum class Side { left, right };
template <>
inline constexpr std::array<std::string_view, 2> words_of<Side>{"left", "right"};

/// Reads "left" or "right". Throws std::invalid_argument for anything else.
Side parse_side(std::string_view text);

/// Rotation from the input frame to the joint frame (x right, y anterior, z superior). The axis code has
/// three letters that say where +x, +y and +z point, one each of R or L (right, left), A or P (anterior,
/// posterior) and S or I (superior, inferior), in any order. "RAS" gives the identity; DICOM and ITK use
/// "LPS". Throws std::invalid_argument for any other text, and for a left-handed code, a mirror image.
Eigen::Matrix3d input_to_joint(std::string_view axis_code);

}  // namespace impinge

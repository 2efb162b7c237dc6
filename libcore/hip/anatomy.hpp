// SPDX-License-Identifier: GPL-3.0-or-later
// The joint frame: which way of the input frame is the patient's right, front and top.
#pragma once

#include <optional>
#include <string_view>

#include <Eigen/Core>

namespace impinge {

/// Of the body, the patient's own.
enum class Side { left, right };

/// "left" or "right", else std::invalid_argument.
Side parse_side(std::string_view text);

/// Rotation from the input frame to the joint frame (x right, y anterior, z superior) for an axis code: three
/// letters that say where +x, +y and +z point, of R or L (right, left), A or P (anterior, posterior), S or I
/// (superior, inferior) in any order. "RAS" is the identity, "LPS" that of DICOM and ITK.
/// std::invalid_argument for anything else, and for a left-handed code, which would mirror the patient.
Eigen::Matrix3d input_to_joint(std::string_view axis_code);

}  // namespace impinge

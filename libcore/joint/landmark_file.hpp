// SPDX-License-Identifier: GPL-3.0-or-later
// Landmarks from a file, and what they make of a joint.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "hip/joint.hpp"

namespace impinge {

/// Reads points by their labels, mm, in the frame of the meshes. What 3D Slicer writes is turned to that
/// frame by `axes` (see input_to_joint()):
///   * .mrk.json, which names its frame; LPS if it does not;
///   * .fcsv, in the frame of its CoordinateSystem: RAS or 0, LPS or 1; RAS if it does not name one. Its
///   comment
///     names the columns; those of Slicer 3 are label,x,y,z,sel,vis;
///   * a table with columns label, r, a, s or label, l, p, s.
/// A table with label, x, y, z is in the frame of the meshes. Tables have commas, semicolons or tabs, and
/// names in any case. A label contains asis or tubercle with left or right, or epicondyle with medial or
/// lateral, in any order and case, as asis_right or "Pubic tubercle, left"; other points are ignored, and so
/// are those that Slicer has not placed. FileError for a file that is none of these, a label that occurs
/// twice, and labels of which none is a landmark's.
Landmarks read_landmarks(const std::filesystem::path& file, const Eigen::Matrix3d& axes);
/// The same of a file's bytes; `file` is its name.
Landmarks read_landmarks(const std::filesystem::path& file, const std::string& bytes,
                         const Eigen::Matrix3d& axes);

/// Adds a point by its label, in the frame of the meshes, mm; other labels are ignored.
/// std::invalid_argument, one line, for a place that is not finite and a label that is there already.
void add_landmark(std::string_view label, const Vec3& place, Landmarks& found);

/// Sets the joint's frames by landmarks (use_frames()). std::runtime_error, one line, if they give none; it
/// begins with `from`, the file or option that they are from.
void use_landmarks(const Landmarks& landmarks, const std::string& from, std::optional<Side> side,
                   Joint& joint);
/// The same with the landmarks of a file.
void use_landmarks(const std::filesystem::path& file, std::optional<Side> side, Joint& joint);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Landmarks from a file, and what they make of a joint.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "hip/joint.hpp"

namespace impinge {

/// Reads points by their labels, mm: from 3D Slicer's .mrk.json, which names its frame (turned to that of the
/// meshes by `axes`, see input_to_joint()), or from a CSV label,x,y,z in the frame of the meshes. A label
/// contains asis or tubercle with left or right, or epicondyle with medial or lateral, in any order and case,
/// as asis_right or "Pubic tubercle, left"; other points are ignored. FileError for a file that is neither,
/// and for a label that occurs twice.
Landmarks read_landmarks(const std::filesystem::path& file, const Eigen::Matrix3d& axes);

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

// SPDX-License-Identifier: GPL-3.0-or-later
// Landmarks from a file, and what they make of a joint.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "hip/joint.hpp"

namespace impinge {

/// Points by their labels: of 3D Slicer's .mrk.json, which says in which frame they are, turned to that of
/// the meshes; or of a CSV label,x,y,z in the frame of the meshes, mm. Labels have the words asis, pubic
/// tubercle or epicondyle, and left or right, medial or lateral, in any order and case, as asis_right or
/// "Pubic tubercle, left"; points with other labels are left out. FileError for a file that is no such thing,
/// and for a label that is there twice.
Landmarks read_landmarks(const std::filesystem::path& file, const Eigen::Matrix3d& axes);

/// Adds one by its label, in the frame of the meshes, mm; none of another label. std::invalid_argument, one
/// line, for a place that is none and a label that is there already.
void add_landmark(std::string_view label, const Vec3& place, Landmarks& found);

/// Takes the joint's frames from them (use_frames()). std::runtime_error, one line with `from`, a file or an
/// option, where they give none.
void use_landmarks(const Landmarks& landmarks, const std::string& from, std::optional<Side> side,
                   Joint& joint);
/// The same of a file.
void use_landmarks(const std::filesystem::path& file, std::optional<Side> side, Joint& joint);

}  // namespace impinge

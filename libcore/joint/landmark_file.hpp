// SPDX-License-Identifier: GPL-3.0-or-later
// Landmarks from a file, and what they make of a joint.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "hip/joint.hpp"

namespace impinge {

/// Reads points by their labels, mm, and returns them in the frame of the meshes. `axes` (see
/// input_to_joint()) turns the files of 3D Slicer to that frame:
///   * .mrk.json, which names its frame; LPS if it does not;
///   * .fcsv, in the frame of its CoordinateSystem: RAS or 0, LPS or 1; RAS if it names none. A comment in
///     the file names the columns; Slicer 3 has label,x,y,z,sel,vis;
///   * a table with columns label, r, a, s or label, l, p, s.
/// A table with label, x, y, z is in the frame of the meshes. Tables have commas, semicolons or tabs, and
/// names in any case. A label contains asis or tubercle with left or right, or epicondyle with medial or
/// lateral, in any order and case, such as asis_right or "Pubic tubercle, left". Other points are ignored,
/// and so are points that Slicer has not placed. Throws FileError for a file that is none of these, for a
/// label that occurs twice, and if no label is a landmark's.
Landmarks read_landmarks(const std::filesystem::path& file, const Eigen::Matrix3d& axes);
/// Reads landmarks from the bytes of a file; `file` is its name.
Landmarks read_landmarks(const std::filesystem::path& file, const std::string& bytes,
                         const Eigen::Matrix3d& axes);

/// Adds a point in the frame of the meshes, mm, if its label is a landmark's, else its label to the others.
/// Throws std::invalid_argument, one line, for a place that is not finite and for a label that is there
/// already.
void add_landmark(std::string_view label, const Vec3& place, Landmarks& found);

/// Sets the joint's frames from landmarks (use_frames()). It warns if there is no epicondyle but another
/// label, which may have been meant for one. Throws std::runtime_error, one line that begins with `from`, the
/// file or option with the landmarks, if they give no frame.
void use_landmarks(const Landmarks& landmarks, const std::string& from, std::optional<Side> side,
                   Joint& joint);
/// Sets the joint's frames from the landmarks of a file.
void use_landmarks(const std::filesystem::path& file, std::optional<Side> side, Joint& joint);

}  // namespace impinge

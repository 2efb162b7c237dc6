// SPDX-License-Identifier: GPL-3.0-or-later
// The bones of a joint in the form that the viewer of a report takes (analysis/joint3d/report/viewer.js).
#pragma once

#include <array>
#include <vector>

#include "joint/document.hpp"
#include "joint/gaps.hpp"

namespace impinge {

/// Meshes about the centre of rotation, mm, with a pose's gaps, the clock and the colours; arrays in base64.
Json report_scene(const SessionJoint& joint, const GapsAnswer& found);

/// Places on the socket's rim about the centre of rotation, mm, with their hours; none without a dial.
struct DrawnRim {
  std::vector<Vec3> places;
  std::vector<float> hours;
};
DrawnRim drawn_rim(const SessionJoint& joint);

/// x' = rotation x + translation, column by column, as in WebGL.
std::array<double, 16> drawn_matrix(const Eigen::Matrix3d& rotation, const Vec3& translation);

}  // namespace impinge

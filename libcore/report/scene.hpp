// SPDX-License-Identifier: GPL-3.0-or-later
// The bones of a joint as the viewer of a report takes them (analysis/joint3d/report/viewer.js).
#pragma once

#include "joint/document.hpp"
#include "joint/gaps.hpp"

namespace impinge {

/// The meshes about the centre of rotation, mm, with the gaps of a pose, the clock and the colours; arrays
/// are texts of base 64.
Json report_scene(const SessionJoint& joint, const GapsAnswer& found);

}  // namespace impinge

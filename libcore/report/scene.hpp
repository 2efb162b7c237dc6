// SPDX-License-Identifier: GPL-3.0-or-later
// The bones of a joint in the form that the viewer of a report takes (analysis/joint3d/report/viewer.js).
#pragma once

#include "joint/document.hpp"
#include "joint/gaps.hpp"

namespace impinge {

/// Meshes about the centre of rotation, mm, with a pose's gaps, the clock and the colours; arrays in base64.
Json report_scene(const SessionJoint& joint, const GapsAnswer& found);

}  // namespace impinge

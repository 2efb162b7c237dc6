// SPDX-License-Identifier: GPL-3.0-or-later
// The motion volume (rotations/volume.hpp), and what a picture of it needs.
#pragma once

#include "joint/session.hpp"
#include "js_values.hpp"

namespace impinge {

/// Of the joint about the centre of the ball, without a shift, until `width` of all rotations is open: shares
/// that are `low`, `high`, `reachable_low` and `reachable_high`, and `states` at the poses of a `grid`: 0
/// where contact stands between a pose and that of the scan, 2 where certainly none does, 1 where it is not
/// known. Rotation is innermost in the order of poses, flexion outermost.
val volume_reply(const SessionJoint& joint, double width);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// What would have to change so that motions are reached, as the page reads it: a cut of the ball
// (joint/resection.hpp), or another orientation of the socket (joint/orientation.hpp).
#pragma once

#include "joint/orientation.hpp"
#include "joint/resection.hpp"
#include "js_values.hpp"

namespace impinge {

/// The cut ball in the centre frame with the `depth` of each vertex, `volume_mm3`, `area_mm2`, `depth_mm` as
/// pairs of ends, `deepest` in the input frame (null where nothing has to go), `neck` (null without one) and
/// `legs` of the required paths, each with its limit `before` and `after`.
val resection_reply(const SessionJoint& joint, const ResectionAnswer& found);

/// `squares`: five numbers each, inclination, anteversion and half width in degrees, the state (0 free, 1
/// blocked, 2 unknown, 3 undecided), and where it is not free the place among `legs`, in words, of one that
/// is so, else -1; `map` says which angles they make up. `as_scanned` of the socket as it is, and `area_deg2`
/// of each state.
val orientation_reply(const OrientationAnswer& found);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// What the page reads beside the documents of answers: arrays.
#pragma once

#include "joint/orient.hpp"
#include "joint/resect.hpp"
#include "joint/volume.hpp"
#include "js_values.hpp"

namespace impinge {

/// The cut bone in the centre frame: `positions`, `faces` and the `depth` of each vertex.
void add_arrays(const SessionJoint& joint, const ResectAnswer& found, val& reply);

/// `squares`: five numbers each, inclination, anteversion and half width in degrees, the state (0 free, 1
/// blocked, 2 unknown, 3 undecided), and where it is not free the place among `legs` of one that is so, else
/// -1.
void add_arrays(const SessionJoint& joint, const OrientAnswer& found, val& reply);

/// `map` (joint/volume_map.hpp): `range_deg` of its squares, abduction innermost, -1 where the pose without
/// rotation is blocked and -2 where that is undecided, and their places by `step`, `flexion` and `abduction`,
/// the least and the most of each.
void add_arrays(const SessionJoint& joint, const VolumeAnswer& found, val& reply);

}  // namespace impinge

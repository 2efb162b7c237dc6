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

/// `states` at the poses of a grid, whose axes are `flexion`, `abduction` and `internal_rotation`
/// (innermost): 0 where contact stands between a pose and that of the scan, 2 where certainly none does, 1
/// where it is not known.
void add_arrays(const SessionJoint& joint, const VolumeAnswer& found, val& reply);

}  // namespace impinge

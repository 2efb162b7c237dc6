// SPDX-License-Identifier: GPL-3.0-or-later
// What a picture of all rotations (joint/volume.hpp) needs beside their document.
#pragma once

#include "hip/anatomy.hpp"
#include "js_values.hpp"
#include "rotations/volume.hpp"

namespace impinge {

/// Adds `states` at the poses of a grid, whose axes are `flexion`, `abduction` and `internal_rotation`
/// (innermost): 0 where contact stands between a pose and that of the scan, 2 where certainly none does, 1
/// where it is not known.
void add_states(const MotionVolume& volume, std::optional<Side> side, val& reply);

}  // namespace impinge

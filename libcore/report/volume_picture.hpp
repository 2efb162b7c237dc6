// SPDX-License-Identifier: GPL-3.0-or-later
// The motion volume as a picture: how far the femur may be rotated about its axis, over flexion and
// abduction.
#pragma once

#include <string>

#include "hip/anatomy.hpp"
#include "rotations/volume.hpp"

namespace impinge {

/// An SVG, 5 degrees a square: the darker, the larger the range from external to internal rotation that is
/// certainly without contact; grey where the pose without rotation is blocked, white where it is undecided.
std::string volume_picture(const MotionVolume& volume, Side side);

}  // namespace impinge

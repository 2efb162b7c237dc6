// SPDX-License-Identifier: GPL-3.0-or-later
// The motion volume as a picture: how far the femur may be rotated about its axis, over flexion and
// abduction.
#pragma once

#include <string>

#include "hip/anatomy.hpp"
#include "rotations/volume.hpp"

namespace impinge {

/// An SVG with a square for each 5 degrees. The darker, the larger the range from external to internal
/// rotation that is certainly without contact; grey: the pose without rotation is blocked; white: undecided.
std::string volume_picture(const MotionVolume& volume, Side side);

/// An SVG of all rotations in the sinusoidal map of Manafzadeh and Gatesy 2020 (doi:10.1242/jeb.227108):
/// abduction upwards, and flexion times the cosine of the abduction across, so that areas are shares of all
/// rotations. The darker, the more of the rotations about the femur's axis are free there.
std::string mobility_picture(const MotionVolume& volume, Side side);

}  // namespace impinge

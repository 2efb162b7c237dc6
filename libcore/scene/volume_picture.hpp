// SPDX-License-Identifier: GPL-3.0-or-later
// The motion volume as a picture: over flexion and abduction how far the ball may be rotated about the axis
// of the femur.
#pragma once

#include <string>

#include "hip/anatomy.hpp"
#include "motion/volume.hpp"

namespace impinge {

/// An SVG, 5 degrees a square: darker where internal and external rotation together go farther without
/// contact, certainly; grey where the pose without rotation is blocked, white where the cells do not say.
std::string volume_picture(const MotionVolume& volume, Side side);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sphere/direction.hpp"

namespace impinge {

/// All directions within `radius` radians of a unit axis.
struct DirectionCap {
  Vec3 axis;            // unit vector
  double radius = 0.0;  // radians
};

/// Of unit vectors, their products and the angles between them (angle_between()), whose rounding is below
/// 16 2^-53 = 1.8e-15.
inline constexpr double kDirectionSlack = 1e-12;

}  // namespace impinge

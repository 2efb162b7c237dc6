// SPDX-License-Identifier: GPL-3.0-or-later
// A point of a Spiral that is treated from the nearer pole.
#pragma once

#include <cmath>

#include "sphere/direction.hpp"
#include "sphere/turn_angle.hpp"

namespace impinge {

/// Direction whose polar angle from the north pole, or else from the south pole, has this haversine.
inline Vec3 spiral_point(double hav, bool south, double turns) {
  const CosSin theta = turn_angle(turns);
  const double sin_phi = 2.0 * std::sqrt(hav * (1.0 - hav));
  const double cos_phi = 1.0 - 2.0 * hav;
  return {sin_phi * theta.cos, sin_phi * theta.sin, south ? -cos_phi : cos_phi};
}

}  // namespace impinge

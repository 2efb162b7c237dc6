// SPDX-License-Identifier: GPL-3.0-or-later
// A range of spherical angles that surely holds a spherical triangle.
#pragma once

#include <array>

#include "sphere/direction.hpp"

namespace impinge {

/// phi in [phi_min, phi_max]; theta from theta_min over theta_width, which is 2 pi where a pole is touched.
/// Radians. theta_min may be negative: angles are to be taken modulo 2 pi.
struct AngularBox {
  double phi_min = 0.0;            // least polar angle
  double phi_max = kPi;            // largest polar angle
  double theta_min = 0.0;          // where the range of azimuths begins
  double theta_width = 2.0 * kPi;  // how far it goes on eastwards
};

/// Box around the triangle whose corners are seen along a, b, c (any length, edges shorter than pi), with the
/// bulge of its great-circle edges, widened by `margin` radians (an angle on the sphere) and a little for
/// rounding.
AngularBox angular_box(const std::array<Vec3, 3>& corners, double margin = 0.0);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// A range of spherical angles that surely holds a spherical triangle.
#pragma once

#include <array>

#include "sphere/direction.hpp"

namespace impinge {

/// The directions with phi in [phi_min, phi_max] and theta in [theta_min, theta_min + theta_width], modulo 2
/// pi. Radians. theta_min may be negative; theta_width is 2 pi if the box touches a pole.
struct AngularBox {
  double phi_min = 0.0;            // least polar angle
  double phi_max = kPi;            // largest polar angle
  double theta_min = 0.0;          // where the range of azimuths begins
  double theta_width = 2.0 * kPi;  // how far it goes on, eastwards
};

/// A box that holds the spherical triangle with these corners (vectors of any length, edges shorter than pi),
/// the bulge of its edges included. It is widened by `margin`, an angle on the sphere in radians, and a
/// little for rounding.
AngularBox angular_box(const std::array<Vec3, 3>& corners, double margin = 0.0);

}  // namespace impinge

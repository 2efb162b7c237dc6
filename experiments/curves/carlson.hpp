// SPDX-License-Identifier: GPL-3.0-or-later
// Carlson's symmetric elliptic integrals through GSL, and Legendre's E of the arcs of this folder in forms
// that add positive terms only: no digits cancel.
#pragma once

namespace impinge {

/// R_F(x, y, z) = 1/2 integral_0^inf dt / sqrt((t + x) (t + y) (t + z)). Arguments are not negative, at most
/// one is zero. std::runtime_error where GSL refuses them.
double gsl_carlson_rf(double x, double y, double z);

/// R_D(x, y, z) = 3/2 integral_0^inf dt / (sqrt((t + x) (t + y)) (t + z)^(3/2)); z above zero.
double gsl_carlson_rd(double x, double y, double z);

/// integral_0^phi sqrt(1 + n sin^2 t) dt for n >= 0 and phi in [0, pi / 2]: E(phi | m = -n), whose form in
/// DLMF 19.25.9 has no term below zero where m is not above it.
double arc_of_growing_speed(double phi, double n);

/// integral_0^phi sqrt(1 - m sin^2 t) dt for m = 1 - rest, 0 < rest <= 1 and phi in [0, pi / 2]: E(phi | m)
/// by DLMF 19.25.10. `rest` is asked for because it is what a caller knows exactly where m is nearly 1.
double arc_of_falling_speed(double phi, double rest);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// What this folder asks GSL for: Carlson's symmetric elliptic integrals, and Legendre's E of the arcs in
// forms that add positive terms only, so that no digits cancel; roots (Brent's method); integrals of smooth
// functions (adaptive Gauss-Kronrod).
#pragma once

#include <functional>

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

/// A root of a continuous function that does not have the same sign at both ends, to a few units of the last
/// digit of the root. std::invalid_argument where the signs are the same or a value is not finite;
/// an exception of the function comes through.
double find_root(const std::function<double(double)>& function, double low, double high);

/// The integral from low to high, to 1e-12 of the integral of |function|. std::runtime_error where that is
/// not reached; an exception of the function comes through.
double integrate(const std::function<double(double)>& function, double low, double high);

// How far rounding may lead past the end of a curve.

/// Of the whole: a length, area or angle that passes the end by no more is at the end.
inline constexpr double kCurveRounding = 1e-12;

}  // namespace impinge

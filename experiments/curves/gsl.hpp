// SPDX-License-Identifier: GPL-3.0-or-later
// Functions from GSL: Carlson's symmetric elliptic integrals; Legendre's E for the arcs, in forms that only
// add positive terms, so that no digits cancel; roots (Brent's method); and integrals of smooth functions
// (adaptive Gauss-Kronrod).
#pragma once

#include <functional>

namespace impinge {

/// R_F(x, y, z) = 1/2 integral_0^inf dt / sqrt((t + x) (t + y) (t + z)). Arguments must not be negative and
/// at most one may be 0. Throws std::runtime_error if GSL refuses them.
double gsl_carlson_rf(double x, double y, double z);

/// R_D(x, y, z) = 3/2 integral_0^inf dt / (sqrt((t + x) (t + y)) (t + z)^(3/2)); z above zero.
double gsl_carlson_rd(double x, double y, double z);

/// integral_0^phi sqrt(1 + n sin^2 t) dt for n >= 0 and phi in [0, pi / 2], which is E(phi | m = -n). The
/// form in DLMF 19.25.9 has no negative term if m <= 0.
double arc_of_growing_speed(double phi, double n);

/// integral_0^phi sqrt(1 - m sin^2 t) dt for m = 1 - rest, 0 < rest <= 1 and phi in [0, pi / 2], which is
/// E(phi | m), by DLMF 19.25.10. It takes `rest` because a caller knows this exactly where m is nearly 1.
double arc_of_falling_speed(double phi, double rest);

/// A root of a continuous function whose signs at the ends differ, to a few units of the root's last digit.
/// Throws std::invalid_argument if the signs are the same or a value is not finite, and passes on exceptions
/// of the function.
double find_root(const std::function<double(double)>& function, double low, double high);

/// The integral from low to high, to 1e-12 of the integral of |function|. Throws std::runtime_error if this
/// is not reached, and passes on exceptions of the function.
double integrate(const std::function<double(double)>& function, double low, double high);

// Allowed rounding past the end of a curve.

/// Share of the whole: a length, area or angle that passes the end by at most this is at the end.
inline constexpr double kCurveRounding = 1e-12;

}  // namespace impinge

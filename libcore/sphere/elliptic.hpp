// SPDX-License-Identifier: GPL-3.0-or-later
// Elliptic integrals, for the lengths of a helix and of a conchoid, with the standard library alone.
#pragma once

namespace impinge {

/// Carlson's symmetric integrals by duplication (Carlson 1995, Numerical Algorithms 10,
/// doi:10.1007/BF02198293), within a few units in the last place. Arguments are not negative and finite, at
/// most one of x, y (and z of R_F) is zero.
///   R_F = 1/2 integral_0^inf dt / sqrt((t + x) (t + y) (t + z))
///   R_D = 3/2 integral_0^inf dt / (sqrt((t + x) (t + y)) (t + z)^(3/2)), z above zero
struct CarlsonIntegrals {
  double rf;  // R_F(x, y, z)
  double rd;  // R_D(x, y, z)
};
CarlsonIntegrals carlson_integrals(double x, double y, double z);  // R_F(x, y, z) and R_D(x, y, z).

/// E(phi | m) = integral_0^phi sqrt(1 - m sin^2 t) dt, Legendre's incomplete integral of the second kind, for
/// phi in [0, pi / 2] and complement = 1 - m > 0, which keeps its digits where m is nearly 1. Only positive
/// terms are added, by DLMF 19.25.9 for m <= 0 and 19.25.10 for m > 0, so that no digit is lost.
double elliptic_e(double phi, double complement);

}  // namespace impinge

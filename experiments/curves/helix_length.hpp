// SPDX-License-Identifier: GPL-3.0-or-later
// The spherical helix theta = 2 k phi (thesis, Eq. 9) as a curve: its length on the unit sphere, exactly and
// as Eq. 10 has it.
//
// phi runs from 0 to pi (radians) and k >= 2 is the number of turns. Lengths are in radii. A k below 2 or not
// finite, a phi outside of [0, pi] and a length beyond the curve are std::invalid_argument.
#pragma once

namespace impinge {

/// L(phi) = integral_0^phi sqrt(1 + 4 k^2 sin^2 t) dt = E(phi | m = -4 k^2), Legendre's incomplete elliptic
/// integral of the second kind.
double helix_length(double turns, double phi);

/// L(pi) = 2 E(m = -4 k^2).
double helix_total_length(double turns);

/// What L(pi) approaches as k grows: 4 k + (ln(8 k) + 1/2) / (2 k). The rest is of order ln(k) / k^3.
double helix_total_length_asymptote(double turns);

/// Eq. 10, the "travelled distance" T(phi) = (4 k + 1) (1 - cos phi) / 2, which the thesis fitted to data.
double travelled_distance(double turns, double phi);

/// 4 k + 1, Eq. 10 at phi = pi.
double total_travelled_distance(double turns);

/// Inverse of helix_length(). A length past the end by rounding is the end.
double polar_angle_at_length(double turns, double length);

/// Inverse of travelled_distance(). A distance past the end by rounding is the end.
double polar_angle_at_travelled_distance(double turns, double distance);

}  // namespace impinge

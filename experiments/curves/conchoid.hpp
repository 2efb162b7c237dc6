// SPDX-License-Identifier: GPL-3.0-or-later
// The conchoid of the hip (thesis, Section 5.1; Menschik 1997): the curve r = a + b cos(phi) (Eq. 11), also
// known as limacon of Pascal, and the surface that it sweeps about its axis phi = 0.
//
// Conchoid frame: the conchoid's origin is the origin, the axis is +z; a point of the meridian is (r sin phi,
// r cos phi). phi runs from 0 (apex) to pi, radians; lengths in mm, areas in mm^2. With b = 0 the curve is a
// circle, with a = b it has a cusp at phi = pi; both are exact. All functions throw std::invalid_argument for
// an invalid shape (require_shape()), a phi outside [0, pi], and a length or area beyond the curve.
#pragma once

#include "sphere/conchoid_shape.hpp"
#include "sphere/direction.hpp"

namespace impinge {

/// phi at the end of the hip's cap: the plane through the origin, perpendicular to the axis.
inline constexpr double kConchoidRim = 0.5 * kPi;

/// Throws unless a > 0, b >= 0 and a >= b, all finite. A conchoid with a < b has a loop through its origin:
/// r changes sign, and a direction would meet it twice.
void require_shape(const ConchoidShape& shape);

/// Throws as require_shape(), and unless phi is in [0, pi].
void require_on_conchoid(const ConchoidShape& shape, double phi);

/// r(phi), Eq. 11.
double conchoid_radius(const ConchoidShape& shape, double phi);

/// Height along the axis of the point at phi, r cos(phi).
double conchoid_height(const ConchoidShape& shape, double phi);
double conchoid_width(const ConchoidShape& shape, double phi);  // its distance from the axis, r sin(phi)

/// ds / dphi = sqrt(r^2 + r'^2) = sqrt(a^2 + b^2 + 2 a b cos phi), mm per radian.
double conchoid_speed(const ConchoidShape& shape, double phi);

/// Length of the meridian from the apex to phi (Eq. 12), exactly:
///   2 (a + b) E(phi / 2 | m),  m = 4 a b / (a + b)^2;  4 a sin(phi / 2) at the cusp.
double meridian_length(const ConchoidShape& shape, double phi);

/// Inverse of meridian_length(). A length that rounding has put past the end counts as the end.
double polar_angle_at_meridian_length(const ConchoidShape& shape, double length);

/// Area of the surface from the apex to phi. With v = ds / dphi at phi and v0 = a + b,
///   A = pi / (2 a^2 b) [2/5 (v0^5 - v^5) + 2/3 (a^2 - b^2) (v0^3 - v^3)],
/// from 2 pi r sin(phi) ds with v^2 in place of phi; v0 - v = 4 a b sin^2(phi / 2) / (v0 + v) removes b from
/// the denominator.
double cap_area(const ConchoidShape& shape, double phi);

/// Inverse of cap_area(). An area that rounding has put past the end counts as the end.
double polar_angle_at_cap_area(const ConchoidShape& shape, double area);

/// Angle psi between the ray from the conchoid's origin and the normal of the surface, radians: tan psi =
/// |r'| / r. At the cusp it is its limit, pi / 2.
double conchoid_incidence(const ConchoidShape& shape, double phi);

/// Area of surface per solid angle seen from the conchoid's origin, r^2 / cos psi, mm^2 per steradian.
double area_per_solid_angle(const ConchoidShape& shape, double phi);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Distances of parts of two surfaces, in double, that are not above the true ones but for a stated rounding.
//
// The plain formulas (mesh/triangle_distance.hpp) lose digits where a face is thin or edges are nearly
// parallel. With u = 2^-53, D the distance between the starts of both parts and k = |sin| of the angle that
// the formula divides by, their error is at most 24 u D / k. Where k is at least kThin that is below 3e-13 D
// and left to the caller's tolerance; below it the error is subtracted, and what holds without the division
// stands in where it says more:
//   of a thin face whose inside may hold the foot of x, no point is farther from an edge than the face's
//   height h: with e the distance of the edges, d^2 >= e^2 - h^2;
//   of two edges at a small angle phi, sliding both feet to the next end changes the distance by phi times
//   the way: d >= e - phi l, l the shorter edge, e the distance of the ends. Theorem 10 (distance).
#pragma once

#include "contact/turn_surface.hpp"

namespace impinge {

/// The sine of the angle of two sides or edges below which the error is subtracted.
inline constexpr double kThin = 1e-2;

/// Distance of x from the face, mm, not above the true one but for the rounding above.
double least_distance(const Vec3& x, const TurnFace& face);
/// The same for the edges a0 a1 and b0 b1, mm.
double least_distance_of_edges(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1);
/// Of two faces that do not pierce each other, mm.
double least_distance(const TurnFace& s, const TurnFace& t);

}  // namespace impinge

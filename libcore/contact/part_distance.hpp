// SPDX-License-Identifier: GPL-3.0-or-later
// Distances of corners, edges and faces of two surfaces, in double, that exceed the true ones by no more than
// a stated rounding.
//
// The plain formulas (mesh/triangle_distance.hpp) lose digits if a face is thin or edges are nearly parallel.
// With u = 2^-53, D the distance between the first corners of both and k = |sin| of the angle that the
// formula divides by, their error is at most 24 u D / k. If k is at least kThin that is below 3e-13 D and
// left to the caller's tolerance. Else the error is subtracted, and the bounds of Theorem 10 (distance),
// which do not divide by k, are used where they say more.
#pragma once

#include "contact/turn_surface.hpp"

namespace impinge {

/// If the sine of the angle between two sides or edges is below this, the error is subtracted.
inline constexpr double kThin = 1e-2;

/// Lower bound on the distance of x from the face, mm, but for the rounding above.
double least_distance(const Vec3& x, const TurnFace& face);
/// The same for the edges a0 a1 and b0 b1, mm.
double least_distance_of_edges(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1);
/// The same for two faces that do not pierce each other, mm.
double least_distance(const TurnFace& s, const TurnFace& t);

}  // namespace impinge

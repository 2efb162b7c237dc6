// SPDX-License-Identifier: GPL-3.0-or-later
// An exact test of whether three points lie on one line.
#pragma once

#include "sphere/direction.hpp"

namespace impinge {

/// True exactly if the three finite points span no area, as the doubles they are. Decided by a rounding error
/// bound if that suffices, else by exact sums of products (Shewchuk, Adaptive precision floating-point
/// arithmetic, 1997), after scaling by a power of two. Exact unless the coordinates of one triple, zeros
/// aside, span more than a factor of 2^480.
bool collinear(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace impinge

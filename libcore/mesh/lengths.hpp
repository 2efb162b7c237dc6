// SPDX-License-Identifier: GPL-3.0-or-later
// The lengths that the library takes, and the refusal of others.
//
// Nothing in it compares a length with a fixed number, so that a surface in other units, 2^k times as large,
// gives the same table times 2^k, bit for bit, as long as no product leaves the range of a double. The
// longest products are the squares of a face's normal times a corner: six lengths. Six of 2^100 mm are 2^600,
// which leaves 2^424 up to the end of the range and 2^422 down to it, for what is much smaller than the
// surface: a component or an edge of 2^-60 of it enters such a square at most four times.
#pragma once

#include "mesh/triangle_mesh.hpp"

namespace impinge {

inline constexpr double kLeastLength = 0x1p-100;  // 7.9e-31 mm
inline constexpr double kMostLength = 0x1p100;    // 1.3e30 mm

/// Throws std::invalid_argument, one line, unless all corners of all faces are finite and the largest
/// coordinate of each face is 0 (a face in the centre, which covers no direction) or from kLeastLength to
/// kMostLength. What fills, asks or bounds a table calls it on the mesh in the centre frame. Vertices of no
/// face may be anything.
void require_lengths(const TriangleMesh& mesh);

/// What squares lengths in floats takes fewer of them. Squares of the largest are 2^120, which leaves room
/// for sums of them below 2^128; squares of the least are 2^-100, 2^26 times the least float that has all its
/// digits (2^-126), so that what is smaller than they by rounding has its digits too.
inline constexpr double kLeastFloatLength = 0x1p-50;  // 8.9e-16 mm
inline constexpr double kMostFloatLength = 0x1p60;    // 1.2e18 mm

/// As require_lengths() of these lengths; what is made for kernels in float, or holds caps, calls it.
void require_float_lengths(const TriangleMesh& mesh);

}  // namespace impinge

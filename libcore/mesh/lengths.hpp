// SPDX-License-Identifier: GPL-3.0-or-later
// The lengths that the library accepts; others are refused.
//
// No code compares a length with a fixed number, so a surface that is 2^k times as large gives the same table
// times 2^k, bit for bit, as long as no product leaves the range of a double. The longest products are the
// squares of a face's normal times a corner: six lengths. Six lengths of 2^100 mm give 2^600, which leaves a
// factor of 2^424 to the upper end of the range (and 2^422 to the lower end for 2^-600). That is enough for
// what is much smaller than the surface: a component or an edge of 2^-60 of it enters such a square at most
// four times.
#pragma once

#include "mesh/triangle_mesh.hpp"

namespace impinge {

inline constexpr double kLeastLength = 0x1p-100;  // 7.9e-31 mm
inline constexpr double kMostLength = 0x1p100;    // 1.3e30 mm

/// Throws std::invalid_argument, one line, unless all corners of all faces are finite and the largest
/// coordinate of each face is 0 (a face in the centre, which covers no direction) or from kLeastLength to
/// kMostLength. Called on the mesh in the centre frame before a table is filled, asked or bounded. Vertices
/// of no face may be anything.
void require_lengths(const TriangleMesh& mesh);

/// Narrower limits for code that squares lengths in floats. Squares of the largest are 2^120, which leaves
/// room for sums below 2^128; squares of the least are 2^-100, 2^26 times the least normal float (2^-126), so
/// that their rounding errors are normal floats as well.
inline constexpr double kLeastFloatLength = 0x1p-50;  // 8.9e-16 mm
inline constexpr double kMostFloatLength = 0x1p60;    // 1.2e18 mm

/// As require_lengths(), with these limits; called where kernels in float or caps are made.
void require_float_lengths(const TriangleMesh& mesh);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// The lengths that the library accepts; others are refused.
//
// No code of tables or contact compares a length with a fixed number, so that a surface 2^k times as large
// gives the same table times 2^k, bit for bit, as long as no product leaves the range of a double. (What is
// asked in mm does: certificates, the distance of the centre, cuts.) The longest products are
// squares of a face's normal times a corner, six lengths: 2^600 for lengths of 2^100 mm, which leaves a
// factor of 2^424 to the upper end of the range (2^422 to the lower end for 2^-600). That is enough for
// components or edges of 2^-60 of the surface, which enter such a square at most four times.
#pragma once

#include "mesh/triangle_mesh.hpp"

namespace impinge {

inline constexpr double kLeastLength = 0x1p-100;  // 7.9e-31 mm
inline constexpr double kMostLength = 0x1p100;    // 1.3e30 mm

/// Throws std::invalid_argument, one line, unless all corners of all faces are finite and the largest
/// coordinate of each face is 0 (a face in the centre, which covers no direction) or from kLeastLength to
/// kMostLength. Vertices of no face may be anything. Called on the mesh in the centre frame before a table is
/// filled, asked or bounded.
void require_lengths(const TriangleMesh& mesh);

/// Narrower limits for code that squares lengths in floats. The largest square is 2^120, which leaves room
/// for sums below 2^128; the least is 2^-100, 2^26 times the least normal float (2^-126), so that its
/// rounding error is a normal float too.
inline constexpr double kLeastFloatLength = 0x1p-50;  // 8.9e-16 mm
inline constexpr double kMostFloatLength = 0x1p60;    // 1.2e18 mm

/// As require_lengths(), with these limits; called before kernels in float or caps are made.
void require_float_lengths(const TriangleMesh& mesh);

}  // namespace impinge

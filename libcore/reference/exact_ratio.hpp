// SPDX-License-Identifier: GPL-3.0-or-later
// Exact arithmetic for the reference distances: sums and products of doubles without rounding (CGAL's Gmpzf,
// an integer of any length times a power of two), their ratios, and one rounding at the end.
#pragma once

#include <CGAL/Gmpzf.h>
#include <CGAL/Simple_cartesian.h>

#include "sphere/direction.hpp"

namespace impinge {

using ExactNumber = CGAL::Gmpzf;                                    // of any size, without rounding
using ExactVector = CGAL::Simple_cartesian<ExactNumber>::Vector_3;  // three such numbers

/// over / under, with under > 0 and over >= 0.
struct ExactRatio {
  ExactNumber over;   // the numerator
  ExactNumber under;  // the denominator
};

/// Compares exactly; both denominators are positive.
inline bool operator<(const ExactRatio& a, const ExactRatio& b) {
  return a.over * b.under < b.over * a.under;
}

inline ExactVector exact(const Vec3& x) { return {x.x(), x.y(), x.z()}; }  // the same vector

/// The double nearest to the square root of the ratio, ties to even: an error of at most half a unit in the
/// last place. The root must be neither subnormal nor above the largest double.
double nearest_root(const ExactRatio& ratio);

}  // namespace impinge

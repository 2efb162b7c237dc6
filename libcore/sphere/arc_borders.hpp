// SPDX-License-Identifier: GPL-3.0-or-later
// Tests whether an arc of a great circle surely meets each cell of a scheme in one stretch, as Theorem 4
// (rim) asks. A border that is a great circle is crossed once at most. Other borders are the lines on which a
// coordinate is a whole number: where the coordinate is monotone along the arc, or passes no whole number,
// the cell has one stretch of it.
#pragma once

#include <algorithm>
#include <cmath>

#include "sphere/direction.hpp"

namespace impinge {

/// Is a coordinate f that goes from f(0) = `from` to f(1) = `to`, with |f''| <= `most_bend`, surely monotone,
/// or surely without a whole number? See the remark after Theorem 4 (rim).
inline bool passes_lines_once(double from, double to, double most_bend) {
  if (std::abs(to - from) > 0.5 * most_bend) return true;
  const double aside = 0.125 * most_bend;
  return std::floor(std::min(from, to) - aside) == std::floor(std::max(from, to) + aside);
}

/// Is the polar angle monotone along the arc from a to b, vectors of any length above zero? Says no for arcs
/// of more than a quarter turn. For schemes whose cells lie between parallels and meridians; the azimuth is
/// monotone along every arc.
///
/// The polar angle falls where z rises, which the sign of b.z (a . a) - a.z (a . b) tells at a and the sign
/// of b.z (a . b) - a.z (b . b) at b. Rounding can hide the highest point of the circle only where an end is
/// within 1e-15 radians of its latitude.
inline bool latitude_is_monotone(const Vec3& a, const Vec3& b) {
  const Vec3 from = a.stableNormalized();
  const Vec3 to = b.stableNormalized();
  const double along = from.dot(to);
  if (along < 0.0) return false;  // near half a turn the digits below cancel
  return (to.z() - from.z() * along) * (to.z() * along - from.z()) >= 0.0;
}

/// Bounds on the spherical angles along a short arc from a to b of length s:
///   |phi''| <= |cot phi|,  |theta'| <= 1 / sin(phi),  |theta''| <= |cot phi| / sin(phi),
/// by the equations of a great circle, phi' = cos(course), theta' = sin(course) / sin(phi). Every point of
/// the arc is within s / 2 of an end.
struct ArcAngles {
  Angles from;    // of a
  Angles to;      // of b
  double turn;    // change of theta along the arc, the short way round
  double length;  // s, radians
  double sine;    // at most the least sin(phi); 0 where the arc may pass a pole

  /// For the arc between two vectors of any length above zero.
  ArcAngles(const Vec3& a, const Vec3& b)
      : from(to_angles(a)),
        to(to_angles(b)),
        turn(std::remainder(to.theta - from.theta, 2.0 * kPi)),
        length(angle_between(a, b)),
        sine(0.0) {
    const double low = std::min(from.phi, to.phi) - 0.5 * length;
    const double high = std::max(from.phi, to.phi) + 0.5 * length;
    if (low > 0.0 && high < kPi) sine = std::min(std::sin(low), std::sin(high));
  }
  double cotangent() const { return std::sqrt((1.0 - sine) * (1.0 + sine)) / sine; }  // at least |cot phi|
};

}  // namespace impinge

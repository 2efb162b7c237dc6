// SPDX-License-Identifier: GPL-3.0-or-later
// Does an arc of a great circle meet each cell of a scheme in one stretch? What a scheme with curved borders
// says about them, for the rim of a surface (table/rim.hpp).
//
// An arc is in a cell while it is between the borders of the cell. It crosses a border that is a great circle
// once at most. Other borders are given as the lines on which a coordinate is a whole number: where a
// coordinate is monotone along the arc, or passes no whole number, the cell has one stretch of it.
//
// Let f be the coordinate on a way from 0 to 1, with |f''| <= B. From Taylor's formula with remainder in
// integral form |f'(t) - (f(1) - f(0))| <= B (t^2 + (1 - t)^2) / 2 <= B / 2, so that f is monotone where
// |f(1) - f(0)| > B / 2; and f is nowhere farther than B / 8 from the line between its ends.
#pragma once

#include <algorithm>
#include <cmath>

#include "sphere/direction.hpp"

namespace impinge {

/// Of a coordinate with these ends: is it monotone, or without a whole number?
inline bool passes_lines_once(double from, double to, double most_bend) {
  if (std::abs(to - from) > 0.5 * most_bend) return true;
  const double aside = 0.125 * most_bend;
  return std::floor(std::min(from, to) - aside) == std::floor(std::max(from, to) + aside);
}

/// Is the polar angle monotone along the arc from a to b, shorter than half a turn? For schemes whose cells
/// lie between parallels and meridians: the azimuth always is. Both of any length above zero.
///
/// It falls where z rises, at a as b.z (a . a) - a.z (a . b) and at b as b.z (a . b) - a.z (b . b). Rounding
/// can only take the highest point of the circle for an end where it is within 1e-15 radians of that
/// latitude.
inline bool latitude_is_monotone(const Vec3& a, const Vec3& b) {
  const Vec3 from = a.stableNormalized();
  const Vec3 to = b.stableNormalized();
  const double along = from.dot(to);
  if (along < 0.0) return false;  // more than a quarter turn: near half a turn the digits below cancel
  return (to.z() - from.z() * along) * (to.z() * along - from.z()) >= 0.0;
}

/// What is known of the spherical angles along a short arc from a to b of length s,
///   |phi''| <= |cot phi|,  |theta'| <= 1 / sin(phi),  |theta''| <= |cot phi| / sin(phi),
/// by the equations of a great circle phi' = cos(course), theta' = sin(course) / sin(phi). No point of it is
/// farther than s / 2 from one of its ends.
struct ArcAngles {
  Angles from;    // of a
  Angles to;      // of b
  double turn;    // change of theta along the arc, the short way round
  double length;  // s, radians
  double sine;    // the least sin(phi), or less; 0 where the arc may pass a pole

  /// Of an arc between two vectors of any length above zero.
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
  double cotangent() const { return std::sqrt((1.0 - sine) * (1.0 + sine)) / sine; }  // |cot phi|, at most
};

}  // namespace impinge

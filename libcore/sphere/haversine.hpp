// SPDX-License-Identifier: GPL-3.0-or-later
// The haversine, hav a = sin(a / 2)^2 = (1 - cos a) / 2: the share of a sphere's height above the polar angle
// a.
#pragma once

#include "sphere/direction.hpp"

namespace impinge {

/// hav of an angle in [0, pi], radians. The error is at most 7e-16, relative up to pi / 2 and absolute
/// beyond. The polynomial interpolates hav(a) / a^2 at Chebyshev nodes, within 6e-18.
inline double haversine(double angle) {
  const bool obtuse = angle > 0.5 * kPi;
  const double x = obtuse ? kPi - angle : angle;
  const double y = x * x;
  const double y2 = y * y;
  const double y4 = y2 * y2;
  const double series =
      ((0.25 - 0.020833333333333332 * y) + (0.0006944444444444408 - 1.2400793650778323e-05 * y) * y2) +
      ((1.3778659608796522e-07 - 1.0438378119385112e-09 * y) +
       (5.735347005437413e-12 - 2.388702444845624e-14 * y) * y2 + 7.584583483408685e-17 * y4) *
          y4;
  return obtuse ? 1.0 - y * series : y * series;
}

}  // namespace impinge

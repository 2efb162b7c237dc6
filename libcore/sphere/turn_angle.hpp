// SPDX-License-Identifier: GPL-3.0-or-later
// Cosine and sine of a number of turns, in plain arithmetic that a compiler turns into vector instructions
// and that gives the same bits on every machine (without contraction to fused multiply-add).
#pragma once

#include <cmath>

#include "sphere/direction.hpp"

namespace impinge {

/// The whole number nearest to x, |x| < 2^51, in default rounding.
inline double nearest_whole(double x) { return (x + 0x1.8p52) - 0x1.8p52; }

/// Cosine and sine of 2 pi `turns`, |turns| < 2^49: within 3e-16, multiples of a quarter turn exact. The
/// polynomials interpolate at Chebyshev nodes an eighth of a turn to either side of a quarter, within 4e-17.
inline CosSin turn_angle(double turns) {
  const double part = turns - nearest_whole(turns);
  const double quarter = nearest_whole(4.0 * part);  // -2 ... 2
  const double x = part - 0.25 * quarter;
  const double y = x * x;
  const double y2 = y * y;
  const double y4 = y2 * y2;
  const double sine = x * (2.0 * kPi + y * ((-41.341702240399755 + 81.6052492760517 * y) +
                                            (-76.70585973562093 + 42.05868918088512 * y) * y2 +
                                            (-15.094054182079999 + 3.78643334956545 * y) * y4));
  const double cosine =
      1.0 +
      y * ((-19.739208802178716 + 64.93939402266824 * y) + (-85.4568172066438 + 60.24464135270201 * y) * y2 +
           ((-26.426253275854723 + 7.903206911569678 * y) - 1.6990343940660637 * y2) * y4);
  const bool odd = quarter * quarter == 1.0;
  const double c = odd ? sine : cosine;
  const double s = odd ? cosine : sine;
  return {quarter * (quarter + 1.0) == 0.0 ? c : -c, quarter * (quarter - 1.0) == 0.0 ? s : -s};
}

/// The direction at the azimuth 2 pi `turns` whose polar angle has the haversine `hav`, from the south pole
/// if `south`, else from the north pole.
inline Vec3 spiral_point(double hav, bool south, double turns) {
  const CosSin theta = turn_angle(turns);
  const double sin_phi = 2.0 * std::sqrt(hav * (1.0 - hav));
  const double cos_phi = 1.0 - 2.0 * hav;
  return {sin_phi * theta.cos, sin_phi * theta.sin, south ? -cos_phi : cos_phi};
}

}  // namespace impinge

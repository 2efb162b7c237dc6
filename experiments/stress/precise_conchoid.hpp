// SPDX-License-Identifier: GPL-3.0-or-later
// The conchoid in 200 bits by its textbook formulas: the truth for the family `conchoid`.
#pragma once

#include "sphere/conchoid_shape.hpp"
#include "stress/precise.hpp"

namespace impinge::lab {

// Lengths in mm, angles in radians. a, b and phi are taken as exact.
class PreciseConchoid {
 public:
  // For this shape, with a and b taken as exact.
  explicit PreciseConchoid(const ConchoidShape& shape) : a_(shape.a), b_(shape.b) {}

  Precise radius(double phi) const { return a_ + b_ * cos(Precise(phi)); }  // a + b cos(phi)
  // ds / dphi
  Precise speed(double phi) const { return sqrt(a_ * a_ + b_ * b_ + 2 * a_ * b_ * cos(Precise(phi))); }

  // 2 (a + b) E(phi / 2 | m), m = 4 a b / (a + b)^2, with E = s R_F - m s^3 R_D / 3, s = sin(phi / 2).
  Precise length(double phi) const {
    const Precise s = sin(Precise(phi) / 2);
    const Precise c = cos(Precise(phi) / 2);
    const Precise m = 4 * a_ * b_ / ((a_ + b_) * (a_ + b_));
    const auto [rf, rd] = carlson(c * c, 1 - m * s * s);
    return 2 * (a_ + b_) * (s * rf - m * s * s * s * rd / 3);
  }

  // pi / (2 a^2 b) [2/5 (v0^5 - v^5) + 2/3 (a^2 - b^2) (v0^3 - v^3)]
  Precise area(double phi) const {
    const Precise v = speed(phi);
    const Precise v0 = a_ + b_;
    const Precise fifth = v0 * v0 * v0 * v0 * v0 - v * v * v * v * v;
    const Precise third = v0 * v0 * v0 - v * v * v;
    return pi() / (2 * a_ * a_ * b_) * (2 * fifth / 5 + 2 * (a_ * a_ - b_ * b_) * third / 3);
  }

  // d area / d phi
  Precise area_rate(double phi) const { return 2 * pi() * radius(phi) * sin(Precise(phi)) * speed(phi); }

 private:
  static Precise pi() { return acos(Precise(-1)); }

  struct Carlson {
    Precise rf;
    Precise rd;
  };

  // R_F(x, y, 1) and R_D(x, y, 1), by duplication until all arguments agree in half of the digits; then the
  // mean is as good as a series.
  static Carlson carlson(Precise x, Precise y) {
    Precise z = 1;
    Precise sum = 0;
    Precise power = 1;
    const Precise small = ldexp(Precise(1), -105);
    while (true) {
      const Precise mean = (x + y + z) / 3;
      if (abs(x - mean) < small * mean && abs(y - mean) < small * mean) break;
      const Precise lambda = sqrt(x) * sqrt(y) + sqrt(z) * (sqrt(x) + sqrt(y));
      sum += power / (sqrt(z) * (z + lambda));
      power /= 4;
      x = (x + lambda) / 4;
      y = (y + lambda) / 4;
      z = (z + lambda) / 4;
    }
    const Precise mean_f = (x + y + z) / 3;
    const Precise mean_d = (x + y + 3 * z) / 5;
    return {1 / sqrt(mean_f), 3 * sum + power / (mean_d * sqrt(mean_d))};
  }

  Precise a_;
  Precise b_;
};

}  // namespace impinge::lab

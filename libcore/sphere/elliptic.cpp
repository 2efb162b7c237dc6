// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/elliptic.hpp"

#include <algorithm>
#include <cmath>

namespace impinge {

// Each duplication brings the arguments four times nearer to their mean. Then a Taylor series of fifth order
// about the mean gives the rest, with an error of the order of the sixth power of the distance that is left.
CarlsonIntegrals carlson_integrals(double x, double y, double z) {
  constexpr double kNear = 1.5e-3;  // 0.2 kNear^6 is below 2^-54
  double sum = 0.0;
  double power = 1.0;  // 4^-n
  double mean_d = 0.0;
  while (true) {
    mean_d = (x + y + 3.0 * z) / 5.0;
    const double away = std::max({std::abs(mean_d - x), std::abs(mean_d - y), std::abs(mean_d - z)});
    if (away < kNear * mean_d) break;
    const double rx = std::sqrt(x);
    const double ry = std::sqrt(y);
    const double rz = std::sqrt(z);
    const double lambda = rx * (ry + rz) + ry * rz;
    sum += power / (rz * (z + lambda));
    power *= 0.25;
    x = 0.25 * (x + lambda);
    y = 0.25 * (y + lambda);
    z = 0.25 * (z + lambda);
  }
  CarlsonIntegrals integrals{};
  {
    const double mean = (x + y + z) / 3.0;
    const double a = (mean - x) / mean;
    const double b = (mean - y) / mean;
    const double c = -a - b;
    const double e2 = a * b - c * c;
    const double e3 = a * b * c;
    integrals.rf = (1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0) / std::sqrt(mean);
  }
  const double a = (mean_d - x) / mean_d;
  const double b = (mean_d - y) / mean_d;
  const double c = -(a + b) / 3.0;
  const double ab = a * b;
  const double cc = c * c;
  const double e2 = ab - 6.0 * cc;
  const double e3 = (3.0 * ab - 8.0 * cc) * c;
  const double e4 = 3.0 * (ab - cc) * cc;
  const double e5 = ab * cc * c;
  const double series = 1.0 - 3.0 * e2 / 14.0 + e3 / 6.0 + 9.0 * e2 * e2 / 88.0 - 3.0 * e4 / 22.0 -
                        9.0 * e2 * e3 / 52.0 + 3.0 * e5 / 26.0;
  integrals.rd = power * series / (mean_d * std::sqrt(mean_d)) + 3.0 * sum;
  return integrals;
}

double elliptic_e(double phi, double complement) {
  const double s = std::sin(phi);
  if (s == 0.0) return 0.0;
  const double c = std::cos(phi);
  const double m = 1.0 - complement;
  const double rest = c * c + complement * s * s;  // 1 - m sin^2 phi
  if (m <= 0.0) {
    const CarlsonIntegrals r = carlson_integrals(c * c, rest, 1.0);
    return s * (r.rf - m / 3.0 * s * s * r.rd);
  }
  // R_F is symmetric in its arguments; in R_D the third one has the power 3/2.
  const CarlsonIntegrals r = carlson_integrals(c * c, 1.0, rest);
  return s * (complement * (r.rf + m / 3.0 * s * s * r.rd) + m * c / std::sqrt(rest));
}

}  // namespace impinge

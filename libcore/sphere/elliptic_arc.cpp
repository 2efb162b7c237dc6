// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/elliptic_arc.hpp"

#include <algorithm>
#include <cmath>

#include "sphere/elliptic.hpp"

namespace impinge {

// Newton's method does not overshoot here. Where the speed rises (complement above 1) the length is convex,
// and as length >= x and length >= sqrt(complement) (1 - cos x) the start is to the right of the answer.
// Where the speed falls the length is concave and at most x, and the start is to the left.
double elliptic_angle(double length, double complement, double end) {
  constexpr int kMostSteps = 100;
  constexpr double kLast = 1e-9;  // share of x; the next step would be about its square
  double x = std::min(length, end);
  if (complement > 1.0) {
    const double share = length / (2.0 * std::sqrt(complement));
    if (share < 1.0) x = std::min(x, 2.0 * std::asin(std::sqrt(share)));
  }
  for (int k = 0; k < kMostSteps; ++k) {
    const double speed = std::hypot(std::cos(x), std::sqrt(complement) * std::sin(x));
    const double step = (elliptic_e(x, complement) - length) / speed;
    x = std::min(x - step, end);
    if (std::abs(step) <= kLast * x) break;
  }
  return x;
}

EllipticArc::EllipticArc(double complement, double end)
    : length_(elliptic_e(end, complement)),
      mean_speed_(std::make_shared<SmoothTable>(
          [complement](double x) { return elliptic_e(x, complement) / x; }, end)),
      mean_slowness_(std::make_shared<SmoothTable>(
          [complement, end](double length) { return elliptic_angle(length, complement, end) / length; },
          length_)) {}

}  // namespace impinge

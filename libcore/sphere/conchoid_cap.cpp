// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/conchoid_cap.hpp"

#include <algorithm>
#include <cmath>

#include "sphere/direction.hpp"

namespace impinge {
namespace {

double complement(double pole_radius) {
  const double ratio = (2.0 - pole_radius) / pole_radius;
  return ratio * ratio;
}

}  // namespace

ConchoidCap::ConchoidCap(Pole pole, double b)
    : pole_radius_(pole == Pole::north ? 1.0 + b : 1.0 - b),
      bend_(pole == Pole::north ? -4.0 * b : 4.0 * b),
      product_((1.0 - b) * (1.0 + b)),
      arc_(complement(pole_radius_), 0.25 * kPi),
      mean_thinness_(
          std::make_shared<SmoothTable>([this](double area) { return find_y(area) / area; }, whole_area())) {}

double ConchoidCap::area(double y) const {
  const double r = pole_radius_;
  const double v = std::sqrt(r * r + bend_ * y);
  const double fourth = (((v + r) * v + r * r) * v + r * r * r) * v + r * r * r * r;
  return 4.0 * kPi * y / (v + r) * (fourth / 5.0 + product_ * ((v + r) * v + r * r) / 3.0);
}

// Newton's method does not overshoot here: at the north pole the area is concave in y and the start is left
// of the answer; at the south pole the area is convex and the start is to the right.
double ConchoidCap::find_y(double wanted) const {
  constexpr int kMostSteps = 200;
  constexpr double kLast = 1e-9;  // share of y; the next step would be about its square
  double y = std::min(wanted / (4.0 * kPi * pole_radius_ * pole_radius_), 0.5);
  for (int k = 0; k < kMostSteps; ++k) {
    const double v = std::sqrt(pole_radius_ * pole_radius_ + bend_ * y);
    const double step = (area(y) - wanted) / (4.0 * kPi * (pole_radius_ + 0.5 * bend_ * y) * v);
    y = std::min(y - step, 0.5);
    if (std::abs(step) <= kLast * y) break;
  }
  return y;
}

}  // namespace impinge

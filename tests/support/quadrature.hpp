// SPDX-License-Identifier: GPL-3.0-or-later
// Gauss-Legendre quadrature, an oracle for closed forms.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "sphere/direction.hpp"

namespace impinge::test {

struct GaussRule {
  static constexpr std::size_t kNodes = 24;
  std::array<double, kNodes> node{};  // in [-1, 1]
  std::array<double, kNodes> weight{};
};

// Nodes by Newton's method on the Legendre polynomial P_n, weights 2 / ((1 - x^2) P_n'(x)^2).
inline GaussRule gauss_rule() {
  GaussRule rule;
  constexpr auto kCount = static_cast<double>(GaussRule::kNodes);
  for (std::size_t k = 0; k < GaussRule::kNodes; ++k) {
    double x = std::cos(kPi * (static_cast<double>(k) + 0.75) / (kCount + 0.5));
    double slope = 0.0;
    for (int step = 0; step < 20; ++step) {
      double before = 1.0;
      double here = x;
      for (double n = 2.0; n <= kCount; n += 1.0) {
        const double next = ((2.0 * n - 1.0) * x * here - (n - 1.0) * before) / n;
        before = here;
        here = next;
      }
      slope = kCount * (x * here - before) / (x * x - 1.0);
      x -= here / slope;
    }
    rule.node[k] = x;
    rule.weight[k] = 2.0 / ((1.0 - x * x) * slope * slope);
  }
  return rule;
}

// Integral of a smooth f, to the rounding where its singularities are farther away than the interval is wide.
template <class F>
double integral(const F& f, double from, double to) {
  static const GaussRule rule = gauss_rule();
  double sum = 0.0;
  for (std::size_t k = 0; k < GaussRule::kNodes; ++k)
    sum += rule.weight[k] * f(0.5 * (from + to) + 0.5 * (to - from) * rule.node[k]);
  return 0.5 * (to - from) * sum;
}

}  // namespace impinge::test

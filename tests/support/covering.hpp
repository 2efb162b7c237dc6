// SPDX-License-Identifier: GPL-3.0-or-later
// Largest distance from directions to the nearest entry of a scheme, found by climbing from random starts.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "sphere/scheme.hpp"
#include "sphere/walker.hpp"
#include "support/directions.hpp"

namespace impinge::test {

// Distance (radians) of u from the nearest entry, by means of the walker.
template <class Walker>
double nearest_entry(const Walker& walker, const Vec3& u, double margin) {
  double nearest = kPi;
  const TriangleCone point(u, u, u);
  walker.visit_near(point, margin, [&](const DirectionRun& run) {
    for (std::size_t k = 0; k < run.count; ++k) nearest = std::min(nearest, angle_between(u, run[k]));
  });
  return nearest;
}

// The best of `starts` random directions with |z| <= z_max, each moved uphill by ever smaller steps. A lower
// bound of the covering radius, within 1e-3 of it where starts are many.
template <SamplingScheme S>
double climbed_gap(const S& scheme, double z_max, std::size_t starts, unsigned seed) {
  const auto& walker = walker_of(scheme);
  const double rho = scheme.covering_radius();
  const double margin = 1.01 * rho;
  double best = 0.0;
  for (Vec3 u : random_directions(starts, seed)) {
    if (std::abs(u.z()) > z_max) continue;
    double gap = nearest_entry(walker, u, margin);
    if (gap < 0.8 * best) continue;
    for (double step = 0.3 * rho; step > 2e-3 * rho; step *= 0.6) {
      const Vec3 east = u.unitOrthogonal();
      const Vec3 north = u.cross(east);
      for (int k = 0; k < 8; ++k) {
        const double angle = k * kPi / 4.0;
        const Vec3 v = (u + step * (std::cos(angle) * east + std::sin(angle) * north)).normalized();
        const double there = nearest_entry(walker, v, margin);
        if (there > gap && std::abs(v.z()) <= z_max) {
          gap = there;
          u = v;
        }
      }
    }
    best = std::max(best, gap);
  }
  return best;
}

// N rho^2, the number by which schemes compare.
template <SamplingScheme S>
double covering_constant(const S& scheme, double rho) {
  return static_cast<double>(scheme.size()) * rho * rho;
}

}  // namespace impinge::test

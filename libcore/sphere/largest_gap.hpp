// SPDX-License-Identifier: GPL-3.0-or-later
// Circles through entries, and by them the covering radius near a pole, by brute force over the few entries
// there.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "sphere/direction.hpp"

namespace impinge {

/// Angle between the directions (phi_1, theta) and (phi_2, theta + theta_apart), accurate for small ones:
/// hav d = hav(phi_1 - phi_2) + sin(phi_1) sin(phi_2) hav(theta_apart), hav a = sin(a / 2)^2. Radians.
inline double separation(double phi_1, double phi_2, double theta_apart) {
  const double along = std::sin(0.5 * (phi_1 - phi_2));
  const double across = std::sin(0.5 * theta_apart);
  const double hav = along * along + std::sin(phi_1) * std::sin(phi_2) * across * across;
  return 2.0 * std::asin(std::sqrt(std::min(hav, 1.0)));
}

/// Direction as far from a, b and c, on the side of a.
inline Vec3 circumcentre(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  if (normal.squaredNorm() == 0.0) return Vec3::Zero();
  return (normal.dot(a) < 0.0 ? -1.0 : 1.0) * normal.normalized();
}

/// Angle from the middle of the smaller circle through three unit vectors to each of them, radians; 0 where
/// two are equal.
inline double circumradius(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 axis = (b - a).cross(c - a);
  return std::atan2(axis.cross(a).norm(), std::abs(axis.dot(a)));
}

/// Largest radius of a circle with no entry inside whose centre has z >= z_min: what is farthest from all
/// entries is the centre of a circle through three of them. `reach` is no smaller than the answer; `entries`
/// hold all with z >= z_min and those within 2 reach of them. Radians.
inline double largest_gap(std::span<const Vec3> entries, double z_min, double reach) {
  // Angles are compared by the squares of their chords.
  const auto chord = [](double angle) { return 4.0 * std::pow(std::sin(0.5 * std::min(angle, kPi)), 2); };
  const double chord_reach = chord(reach);
  const double chord_around = chord(2.0 * reach);
  constexpr double kEmpty = 1.0 - 2e-6;
  double largest = 0.0;
  std::vector<Vec3> around;  // entries within 2 reach of one, those after it last
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Vec3& a = entries[i];
    around.clear();
    std::size_t after = 0;
    for (std::size_t j = 0; j < entries.size(); ++j) {
      if (entries[j] != a && (entries[j] - a).squaredNorm() <= chord_around) around.push_back(entries[j]);
      if (j <= i) after = around.size();
    }
    for (std::size_t j = after; j < around.size(); ++j) {
      for (std::size_t k = j + 1; k < around.size(); ++k) {
        const Vec3 centre = circumcentre(a, around[j], around[k]);
        if (centre.isZero() || centre.z() < z_min) continue;
        const double radius = (centre - a).squaredNorm();
        if (radius <= largest || radius > chord_reach) continue;
        const bool empty = std::ranges::none_of(
            around, [&](const Vec3& b) { return (centre - b).squaredNorm() < radius * kEmpty; });
        if (empty) largest = radius;
      }
    }
  }
  return 2.0 * std::asin(std::min(0.5 * std::sqrt(largest), 1.0));
}

}  // namespace impinge

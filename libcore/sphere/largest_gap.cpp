// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/largest_gap.hpp"

#include <cstddef>
#include <vector>

namespace impinge {

double largest_gap(std::span<const Vec3> entries, double z_min, double reach) {
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

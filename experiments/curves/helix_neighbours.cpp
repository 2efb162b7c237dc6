// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves/helix_neighbours.hpp"

#include <algorithm>
#include <cmath>

#include "curves/helix_length.hpp"

namespace impinge {

std::optional<HelixNeighbours> helix_neighbours(const HelixEntries& entries, const Vec3& x) {
  const Angles at = to_angles(x);
  const double slope = 2.0 * entries.turns;
  const double above = std::floor((slope * at.phi - at.theta) / (2.0 * kPi));
  HelixNeighbours found;
  found.phi_above = (at.theta + 2.0 * kPi * above) / slope;
  found.phi_below = found.phi_above + 2.0 * kPi / slope;
  if (found.phi_above < 0.0 || found.phi_below > kPi) return std::nullopt;
  found.travelled_above = travelled_distance(entries.turns, found.phi_above);
  found.travelled_below = travelled_distance(entries.turns, found.phi_below);
  const double spacing = total_travelled_distance(entries.turns) / static_cast<double>(entries.count - 1);
  const auto before = [&](double travelled) {
    return std::min(static_cast<std::size_t>(travelled / spacing), entries.count - 2);
  };
  const std::size_t a = before(found.travelled_above);
  const std::size_t b = before(found.travelled_below);
  found.entry = {a, a + 1, b, b + 1};
  return found;
}

}  // namespace impinge

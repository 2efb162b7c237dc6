// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/gap_levels.hpp"

#include <cmath>
#include <limits>

namespace impinge {

std::vector<GapLevel> gap_levels(Surface surface, double cartilage_mm) {
  constexpr double beyond = std::numeric_limits<double>::infinity();
  std::vector<GapLevel> levels{{0.0, "bones touch or overlap", {59, 15, 112}}};
  if (cartilage_mm > 0.0) {
    levels.push_back({cartilage_mm / 3.0, "first third of the cartilage", {179, 40, 45}});
    levels.push_back({cartilage_mm * 2.0 / 3.0, "second third of the cartilage", {240, 127, 28}});
    levels.push_back({cartilage_mm, "last third of the cartilage", {247, 220, 111}});
  }
  levels.push_back(surface == Surface::ball ? GapLevel{beyond, "no impingement", {63, 159, 107}}
                                            : GapLevel{beyond, "no impingement", {59, 127, 191}});
  return levels;
}

Rgb gap_colour(double gap_mm, const std::vector<GapLevel>& levels) {
  if (std::isnan(gap_mm)) return kNoGapColour;
  for (const GapLevel& level : levels) {
    if (gap_mm <= level.up_to_mm) return level.colour;
  }
  return levels.back().colour;
}

}  // namespace impinge

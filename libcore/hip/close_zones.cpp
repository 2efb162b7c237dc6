// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/close_zones.hpp"

#include <cassert>

namespace impinge {

std::vector<ClockZone> close_zones(const ClockFace& dial, const PosedGaps& surface, double threshold) {
  assert(surface.gap.size() == surface.vertices.size() && surface.gap.size() == surface.area.size());
  std::vector<double> hours;
  std::vector<double> area;
  for (std::size_t i = 0; i < surface.gap.size(); ++i) {
    if (!(surface.gap[i] <= threshold)) continue;  // NaN is not close
    hours.push_back(dial.hours(surface.vertices[i]));
    area.push_back(surface.area[i]);
  }
  return clock_zones(hours, area);
}

}  // namespace impinge

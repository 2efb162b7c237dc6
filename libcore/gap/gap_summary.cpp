// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/gap_summary.hpp"

#include <cassert>
#include <cmath>

namespace impinge {

GapSummary summarise(std::span<const double> gap, std::span<const double> vertex_area, double threshold) {
  assert(gap.size() == vertex_area.size());
  GapSummary summary;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    if (std::isnan(gap[i])) continue;
    ++summary.met;
    if (!summary.smallest || gap[i] < summary.smallest_gap) {
      summary.smallest = i;
      summary.smallest_gap = gap[i];
    }
    if (gap[i] <= threshold) {
      ++summary.impinged;
      summary.impinged_area += vertex_area[i];
    }
  }
  return summary;
}

}  // namespace impinge

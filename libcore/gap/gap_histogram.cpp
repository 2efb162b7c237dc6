// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/gap_histogram.hpp"

#include <cassert>
#include <cmath>
#include <cstddef>

namespace impinge {

GapHistogram gap_histogram(std::span<const double> gap, std::span<const double> vertex_area) {
  assert(gap.size() == vertex_area.size());
  GapHistogram found;
  const auto bins = static_cast<double>(found.area.size());
  for (std::size_t i = 0; i < gap.size(); ++i) {
    const double bin = std::floor((gap[i] - found.first) / found.width);
    double& share = std::isnan(gap[i]) ? found.without
                    : bin < 0.0        ? found.below
                    : bin >= bins      ? found.beyond
                                       : found.area[static_cast<std::size_t>(bin)];
    share += vertex_area[i];
  }
  return found;
}

}  // namespace impinge

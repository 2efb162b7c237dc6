// SPDX-License-Identifier: GPL-3.0-or-later
// How the area of a surface is spread over its gaps.
#pragma once

#include <span>
#include <vector>

namespace impinge {

/// Areas by gap, in bins of equal width from `first` on, and the areas outside of the bins.
struct GapHistogram {
  double first = -5.0;                                      // where bin 0 begins, mm
  double width = 0.5;                                       // of a bin, mm
  std::vector<double> area = std::vector<double>(40, 0.0);  // of each bin, mm^2
  double below = 0.0;                                       // mm^2 with gaps under `first`
  double beyond = 0.0;                                      // mm^2 with gaps at the last bin's end or above
  double without = 0.0;                                     // mm^2 without a gap: no surface is met
};

/// Adds the area of each vertex, mm^2, to the bin of its gap: [first + k width, first + (k + 1) width) for
/// bin k. `gap` is in mm, NaN where no surface is met; both must have the same size.
GapHistogram gap_histogram(std::span<const double> gap, std::span<const double> vertex_area);

}  // namespace impinge

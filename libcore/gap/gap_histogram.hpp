// SPDX-License-Identifier: GPL-3.0-or-later
// How the area of a surface is spread over its gaps.
#pragma once

#include <span>
#include <vector>

namespace impinge {

/// Bins of equal width from `first` on, and what lies outside of them. mm, mm^2.
struct GapHistogram {
  double first = -5.0;                                      // where bin 0 begins, mm
  double width = 0.5;                                       // of a bin, mm
  std::vector<double> area = std::vector<double>(40, 0.0);  // of each bin, mm^2
  double below = 0.0;                                       // gaps under `first`
  double beyond = 0.0;                                      // gaps at the end of the last bin or above
  double without = 0.0;                                     // no gap: the other surface is not met
};

/// Adds each vertex' area to the bin of its gap: [first + k width, first + (k + 1) width) for bin k. gap in
/// mm, NaN where no surface is met; both must have the same size.
GapHistogram gap_histogram(std::span<const double> gap, std::span<const double> vertex_area);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Summarises the gaps of one surface: the smallest one, and how much is impinged.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace impinge {

struct GapSummary {
  std::optional<std::size_t>
      smallest;                // vertex with the smallest gap; none if the other surface is never met
  double smallest_gap = 0.0;   // mm, its gap
  std::size_t met = 0;         // number of vertices that meet the other surface
  std::size_t impinged = 0;    // how many of these have a gap of at most the threshold
  double impinged_area = 0.0;  // mm^2, area of the impinged vertices
};

/// The summary of these gaps (mm, NaN where no surface is met); vertex_area in mm^2, see vertex_areas(). A
/// vertex is impinged if its gap is `threshold` mm or less: 0 means bone on bone; the thickness of both
/// layers of cartilage means that these touch (the thesis, Section 3.4, takes 4 mm).
GapSummary summarise(std::span<const double> gap, std::span<const double> vertex_area, double threshold);

}  // namespace impinge

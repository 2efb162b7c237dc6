// SPDX-License-Identifier: GPL-3.0-or-later
// What the gaps of one surface say about the joint.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace impinge {

struct GapSummary {
  std::optional<std::size_t>
      smallest;                // vertex with the smallest gap; none if the other surface is never met
  double smallest_gap = 0.0;   // mm, its gap
  std::size_t met = 0;         // vertices that meet the other surface
  std::size_t impinged = 0;    // of these, with a gap of at most the threshold
  double impinged_area = 0.0;  // mm^2 of their faces
};

/// gap in mm, NaN where no surface is met; vertex_area in mm^2, see vertex_areas(). A vertex is impinged at a
/// gap of `threshold` mm or less: 0 is bone on bone, the thickness of the two layers of cartilage is where
/// they touch (the thesis, Section 3.4, takes 4 mm).
GapSummary summarise(std::span<const double> gap, std::span<const double> vertex_area, double threshold);

}  // namespace impinge

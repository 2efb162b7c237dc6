// SPDX-License-Identifier: GPL-3.0-or-later
// Where on the dial two surfaces are close: the "red zones" of the thesis in hours.
#pragma once

#include <span>
#include <vector>

#include "hip/clock.hpp"

namespace impinge {

/// One surface in a pose: for each vertex its place (joint frame, centre as origin), its gap (NaN where the
/// other surface is not met) and its share of the surface (vertex_areas()). All of one size.
struct PosedGaps {
  std::span<const Vec3> vertices;  // mm
  std::span<const double> gap;     // mm, or shares of the cartilage (cartilage_map.hpp)
  std::span<const double> area;    // mm^2, of each
};

/// Stretches of the dial with a gap of at most `threshold` (in the gaps' unit), the largest area first.
std::vector<ClockZone> close_zones(const ClockFace& dial, const PosedGaps& surface, double threshold);

}  // namespace impinge

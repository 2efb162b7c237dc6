// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps as text for the file gaps.csv.
#pragma once

#include <span>
#include <string>

#include "hip/gap_levels.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// One posed surface: the places of its vertices and their gaps, NaN where the other surface is not met. Both
/// have the same size.
struct GapsOfSurface {
  Surface surface = Surface::ball;  // whose vertices they are
  std::span<const Vec3> places;     // mm, input frame
  std::span<const double> gap;      // mm, of each
};

/// CSV text with the header surface,vertex,x,y,z,gap_mm. A number is the shortest text that reads back as the
/// same double; gap_mm is empty for NaN. The ball's vertices come first, then the socket's; an empty surface
/// has no lines.
std::string gaps_csv(const GapsOfSurface& ball, const GapsOfSurface& socket);

}  // namespace impinge

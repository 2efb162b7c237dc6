// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps as files: gaps.csv, and a PLY of one surface.
#pragma once

#include <span>
#include <string>

#include "hip/gap_levels.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// One surface as it is posed: the places of its vertices in the input frame and their gaps, mm, NaN where
/// the other surface is not met. Of one size.
struct GapsOfSurface {
  Surface surface = Surface::ball;  // whose vertices they are
  std::span<const Vec3> places;     // mm, input frame
  std::span<const double> gap;      // mm, of each
};

/// surface,vertex,x,y,z,gap_mm with a header line; numbers as the shortest text that reads back as the same
/// double, and no gap where there is none. All of the ball, then all of the socket; an empty one has no
/// lines.
std::string gaps_csv(const GapsOfSurface& ball, const GapsOfSurface& socket);

}  // namespace impinge

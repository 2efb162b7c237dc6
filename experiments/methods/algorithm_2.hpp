// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison of the thesis' Algorithms 2 and 3 as they are written, beside the signed gap.
#pragma once

#include <cstddef>
#include <span>

#include "gap/surface.hpp"

namespace impinge::lab {

// How many vertices of a scan either comparison calls impinged.
struct ScanVerdicts {
  std::size_t met = 0;         // vertices that meet the other surface
  std::size_t by_gap = 0;      // of these, with a gap of 0 or less
  std::size_t as_written = 0;  // of these, with d <= d_i: d from the table, d_i of the vertex
};

// gap in mm, NaN where no surface is met, as scan_gaps() gives it: d - d_i for vertices of the ball, d_i - d
// for those of the socket. The thesis applies the same comparison d <= d_i to both.
ScanVerdicts compare_as_written(std::span<const double> gap, Surface scanned);

}  // namespace impinge::lab

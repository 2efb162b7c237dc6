// SPDX-License-Identifier: GPL-3.0-or-later
// The least work of any look-up in a table: read a vertex, move it by the pose, read one entry, write a
// number. Its time is a lower limit for kernels; its answers mean nothing.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "gap/simd/gap_kernels.hpp"

namespace impinge::lab {

// A square table filled with ones.
struct FloorTable {
  // A table of at least so many bytes, for vertices up to `most_distant` mm from the centre.
  FloorTable(std::size_t bytes, double most_distant)
      : side(static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(bytes) / sizeof(float))))),
        reach(static_cast<float>(most_distant)),
        values(side * side, 1.0F) {}

  std::size_t side;           // number of rows, and of entries per row
  float reach;                // mm
  std::vector<float> values;  // all 1
};

// Writes one number per vertex to `out`. Leaves out vertices beyond the last full SIMD vector.
void floor_scan(const FloorTable& table, const PackedVertices<float>& vertices, const Pose& pose,
                Surface scanned, std::span<float> out);

}  // namespace impinge::lab

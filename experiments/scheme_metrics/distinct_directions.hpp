// SPDX-License-Identifier: GPL-3.0-or-later
// Entries that share one direction, as those of a pole row or on the edges of a cube map do, taken together.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sphere/direction.hpp"

namespace impinge {

/// Entries no farther apart count as one direction: far above rounding, far below any spacing. Radians.
inline constexpr double kCoincident = 1e-9;

struct DistinctDirections {
  std::vector<Vec3> direction;        // that of the first entry of each
  std::vector<std::size_t> of_entry;  // place of each entry in `direction`
  std::vector<std::size_t> entries;   // number of entries of each direction
};

/// Unit vectors in, in the order of the entries; directions come out in the order of their first entry.
/// std::invalid_argument where one is not finite or is zero.
DistinctDirections distinct_directions(std::span<const Vec3> entries);

}  // namespace impinge

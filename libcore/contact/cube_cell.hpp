// SPDX-License-Identifier: GPL-3.0-or-later
// Cells on the faces of a cube. From level to level each is halved three times; the numbers of its parts
// follow each other.
#pragma once

#include <array>
#include <cstddef>

#include "sphere/direction.hpp"

namespace impinge {

/// A cell of a level. `prefix` is the face of the cube followed by three bits for each level, taken from the
/// coordinates b and a in turn.
struct CubeCell {
  std::size_t level;   // 0 is the face
  std::size_t prefix;  // see above
};

/// Number (prefix) of the cell of a level that holds the direction.
std::size_t cell_of(const Vec3& axis, std::size_t level);

/// Corners of a cell, of any length.
std::array<Vec3, 4> cell_corners(const CubeCell& cell);

}  // namespace impinge

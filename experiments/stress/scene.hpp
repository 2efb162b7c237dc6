// SPDX-License-Identifier: GPL-3.0-or-later
// What the methods of one case are asked, and of which surface.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// A surface and the directions along which it is asked.
struct StabilityScene {
  TriangleMesh mesh;  // centre frame, mm
  // Of any length above zero. Rays are cast along them; tables are looked up there, and examined at their own
  // entries too.
  std::vector<Vec3> directions;
  // Places of two directions that are the same one, differently written: answers have the same bits.
  std::vector<std::array<std::size_t, 2>> twins;
  double precision_deg = 10.0;  // of the tables
};

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a table against brute force over the mesh, before its filling is timed.
#pragma once

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "table/pairwise.hpp"

namespace impinge::lab {

struct TableCheck {
  std::size_t entries = 2000;  // compared, evenly through the table
  double tolerance = 0.0;      // mm
  // Must the table have a radius exactly where rays meet the mesh? If not, only entries with a radius in both
  // are compared: a rasteriser that bends edges covers other entries along a rim.
  bool same_cover = true;
};

// Mesh in the centre frame. Throws std::runtime_error that names the first entry that is wrong.
template <SamplingScheme S>
void require_radii(const RadialTable<S>& table, const TriangleMesh& mesh, Layer layer,
                   const TableCheck& check) {
  const RayCaster oracle(mesh);
  const std::size_t stride = table.scheme().size() / check.entries + 1;
  for (std::size_t i = 0; i < table.scheme().size(); i += stride) {
    const double expected = oracle.cast(table.scheme().direction(i), layer);
    const double radius = table.radii()[i];
    const bool wrong_cover = check.same_cover && std::isnan(radius) != std::isnan(expected);
    if (!wrong_cover && !(std::abs(radius - expected) > check.tolerance)) continue;
    throw std::runtime_error("entry " + std::to_string(i) + " of a table at " +
                             std::to_string(table.scheme().precision_deg()) + " degrees holds " +
                             std::to_string(radius) + " mm, but the mesh is at " + std::to_string(expected) +
                             " mm: its time means nothing until the filling is right");
  }
}

}  // namespace impinge::lab

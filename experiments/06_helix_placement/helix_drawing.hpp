// SPDX-License-Identifier: GPL-3.0-or-later
// What the figures of the thesis' helix draw (Figures 47-48), on the unit sphere.
#pragma once

#include <cstddef>
#include <span>

#include "harness/provenance.hpp"
#include "sphere/direction.hpp"

namespace impinge::lab {

// helix_curve.csv: the entries of each helix, and points of the curve between them.
Result helix_curve(std::span<const std::size_t> turns);

// helix_neighbours.csv: the steps of the look-up of a vertex in this direction, and the way from the start of
// the curve to P_b. std::invalid_argument where the vertex has three neighbours.
Result helix_neighbours_of(std::size_t turns, const Vec3& vertex);

}  // namespace impinge::lab

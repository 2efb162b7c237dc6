// SPDX-License-Identifier: GPL-3.0-or-later
// The look-up of the thesis' helix step by step (Section 4.3, Figure 48), for entries at equal travelled
// distance. The scheme Usid does the same in one go; this keeps what a figure shows.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "curves/helix_entries.hpp"
#include "sphere/direction.hpp"

namespace impinge {

struct HelixNeighbours {
  double phi_above = 0.0;        // of P_a, where the half plane of the vertex' theta meets the turn above it
  double phi_below = 0.0;        // of P_b, on the turn below; radians
  double travelled_above = 0.0;  // T of P_a (Eq. 10), radii
  double travelled_below = 0.0;  // T of P_b
  std::array<std::size_t, 4> entry{};  // P_0 and P_1 round P_a, P_2 and P_3 round P_b
};

/// Neighbours of a vertex in direction x (of any length above zero). None above the first turn and below the
/// last one, where a vertex has three.
std::optional<HelixNeighbours> helix_neighbours(const HelixEntries& entries, const Vec3& x);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// The rim mask: which cells of a table the edge of a surface crosses.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mesh/jump_edges.hpp"
#include "sampling/layer.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {

// Points along an edge are this share of the covering radius apart, so that an edge which cuts off less than
// an eighth of a cell may go unnoticed.
inline constexpr double kRimStep = 0.125;

// Can a point of a jump edge at this radius belong to the layer that the taps sample? A layer changes by at
// most exp(slope * angle) within the stencil; an edge farther off is hidden behind it (or lies before it).
template <SamplingScheme S>
bool edge_is_seen(const RadialTable<S>& table, const Stencil& stencil, double radius, double slope,
                  Layer layer) {
  const double reach = std::exp(slope * table.scheme().stencil_radius());
  double low = table.radii()[stencil.entry[0]];
  double high = low;
  for (std::size_t k = 1; k < stencil.taps; ++k) {
    low = std::min(low, table.radii()[stencil.entry[k]]);
    high = std::max(high, table.radii()[stencil.entry[k]]);
  }
  return layer == Layer::nearest ? radius <= high * reach : radius * reach >= low;
}

// Marks every cell in which all entries have a radius but the surface ends or jumps between them. (A cell
// with an empty entry needs no mark: the empty entry speaks for it.)
template <SamplingScheme S>
void mask_rim(const TriangleMesh& mesh, Layer layer, RadialTable<S>& table) {
  const double step = kRimStep * table.scheme().covering_radius();
  for (const JumpEdge& edge : jump_edges(mesh)) {
    const Vec3& from = mesh.vertices[edge.from];
    const Vec3& to = mesh.vertices[edge.to];
    const auto pieces = static_cast<std::size_t>(angle_between(from, to) / step) + 1;
    for (std::size_t k = 0; k <= pieces; ++k) {
      const Vec3 x = from + (to - from) * (static_cast<double>(k) / static_cast<double>(pieces));
      if (x.squaredNorm() == 0.0) continue;
      const Stencil stencil = table.scheme().stencil(x);
      const bool full = std::none_of(stencil.entry.begin(), stencil.entry.begin() + stencil.taps,
                                     [&](std::size_t i) { return std::isnan(table.radii()[i]); });
      if (full && edge_is_seen(table, stencil, x.norm(), edge.slope, layer))
        table.mark_rim_cell(stencil.cell);
    }
  }
}

}  // namespace impinge

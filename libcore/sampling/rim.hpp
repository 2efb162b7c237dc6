// SPDX-License-Identifier: GPL-3.0-or-later
// The rim mask: which cells of a table the edge of a surface crosses.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Geometry>

#include "mesh/jump_edges.hpp"
#include "sampling/layer.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {

// An edge is followed in steps of this share of the covering radius, and each change of cell between two
// steps is traced to its place. Only a stretch that leaves a cell and returns to it within a step can go
// unseen; it cuts off no entry.
inline constexpr double kRimStep = 0.125;

// An edge may run along the border of two cells, both of which it then separates: it is followed at this
// distance on either side, radians.
inline constexpr double kBesideEdge = 1e-9;

// A change of cell is traced to within this, radians: far less than how far beside the edge it is followed.
inline constexpr double kRimPlace = 1e-12;

// Calls visit(stencil, x) once for each stretch of the line from `from` to `to` within one cell, in order; x
// is a point of it.
template <SamplingScheme S, class Visit>
void for_each_cell_along(const S& scheme, const Vec3& from, const Vec3& to, Visit&& visit) {
  const auto point = [&](double t) -> Vec3 { return from + t * (to - from); };
  const double step = kRimStep * scheme.covering_radius();
  const double length = angle_between(from, to);
  const double near = kRimPlace / std::max(length, kRimPlace);
  const auto pieces = static_cast<std::size_t>(length / step) + 1;
  double at = 0.0;
  Stencil here = scheme.stencil(from);
  visit(here, from);
  for (std::size_t k = 1; k <= pieces; ++k) {
    const double next = static_cast<double>(k) / static_cast<double>(pieces);
    const std::size_t next_cell = scheme.stencil(point(next)).cell;
    while (here.cell != next_cell) {
      double inside = at;
      double outside = next;
      while (outside - inside > near) {
        const double middle = 0.5 * (inside + outside);
        (scheme.stencil(point(middle)).cell == here.cell ? inside : outside) = middle;
      }
      at = outside;
      here = scheme.stencil(point(at));
      visit(here, point(at));
    }
    at = next;
  }
}

// Can a point of a jump edge at this radius belong to the layer that the taps sample? A layer changes by at
// most exp(slope * angle) within the stencil; an edge farther off is hidden behind it (or lies before it).
// The slope is that of the faces at the edge: where the layer gets much steeper within one cell (a coarse
// table over a fine, oblique mesh) an edge that is seen may be taken for hidden.
template <SamplingScheme S>
bool edge_is_seen(const RadialTable<S>& table, const Stencil& stencil, double radius, double slope,
                  Layer layer) {
  const double reach = std::exp(slope * table.scheme().stencil_radius());
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;
  for (std::size_t k = 0; k < stencil.taps; ++k) {
    const double tap = table.radii()[stencil.entry[k]];
    if (std::isnan(tap)) continue;
    low = std::min(low, tap);
    high = std::max(high, tap);
  }
  return layer == Layer::nearest ? radius <= high * reach : radius * reach >= low;
}

// Calls visit(stencil) for the cells that may read a tap across the cell of `at`: itself, and those that a
// scheme whose taps reach beyond the corners of a cell names in for_each_cell_across().
template <SamplingScheme S, class Visit>
void for_each_cell_reading(const S& scheme, const Stencil& at, Visit&& visit) {
  visit(at);
  if constexpr (requires { scheme.for_each_cell_across(at, visit); }) scheme.for_each_cell_across(at, visit);
}

// Marks the cell if at least two of its entries have a radius that may belong to the layer of the edge. (One
// alone is not mixed with anything; an empty entry speaks for its cell, but not on the line between two
// others.)
template <SamplingScheme S>
void mask_cell(const Stencil& stencil, double radius, double slope, Layer layer, RadialTable<S>& table) {
  const auto filled = std::count_if(stencil.entry.begin(), stencil.entry.begin() + stencil.taps,
                                    [&](std::size_t i) { return !std::isnan(table.radii()[i]); });
  if (filled > 1 && edge_is_seen(table, stencil, radius, slope, layer)) table.mark_rim_cell(stencil.cell);
}

// Marks every cell in which the surface ends or jumps between the entries that it reads.
template <SamplingScheme S>
void mask_rim(const TriangleMesh& mesh, Layer layer, RadialTable<S>& table) {
  for (const JumpEdge& edge : jump_edges(mesh)) {
    const Vec3& from = mesh.vertices[edge.from];
    const Vec3& to = mesh.vertices[edge.to];
    const Vec3 across = from.cross(to);
    if (across.squaredNorm() == 0.0) continue;  // seen as a point
    for (const double side : {-kBesideEdge, kBesideEdge}) {
      const Vec3 aside = side * across.normalized();
      for_each_cell_along(table.scheme(), from + from.norm() * aside, to + to.norm() * aside,
                          [&](const Stencil& stencil, const Vec3& x) {
                            for_each_cell_reading(table.scheme(), stencil, [&](const Stencil& reader) {
                              mask_cell(reader, x.norm(), edge.slope, layer, table);
                            });
                          });
    }
  }
}

}  // namespace impinge

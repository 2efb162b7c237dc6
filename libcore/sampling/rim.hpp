// SPDX-License-Identifier: GPL-3.0-or-later
// The rim mask: which cells of a table the edge of a surface crosses.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <vector>

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
template <class S, class Visit>
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

// By how much ln r would have to change from a filled tap, the most favourable one, to the edge for the edge
// to belong to the layer; 0 or less if not at all.
template <class Table>
double change_to_be_seen(const Table& table, const Stencil& stencil, double radius, Layer layer) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < stencil.taps; ++k) {
    const double tap = table.radius_of(stencil.entry[k]);
    if (!std::isnan(tap))
      least = std::min(least, layer == Layer::nearest ? std::log(radius / tap) : std::log(tap / radius));
  }
  return least;
}

// Calls visit(stencil) for the cells that may read a tap across the cell of `at`: itself, and those that a
// scheme whose taps reach beyond the corners of a cell names in for_each_cell_across().
template <class S, class Visit>
void for_each_cell_reading(const S& scheme, const Stencil& at, Visit&& visit) {
  visit(at);
  if constexpr (requires { scheme.for_each_cell_across(at, visit); }) scheme.for_each_cell_across(at, visit);
}

// Has the cell two entries or more that a rim could part? (One alone is not mixed with anything; an empty
// entry speaks for its cell, but not on the line between two others.)
template <class Table>
bool may_be_parted(const Table& table, const Stencil& stencil) {
  return std::count_if(stencil.entry.begin(), stencil.entry.begin() + stencil.taps,
                       [&](std::size_t i) { return !std::isnan(table.radius_of(i)); }) > 1;
}

// An edge in a cell that the faces at the edge alone would call hidden.
struct DoubtfulRim {
  Stencil reader;  // of the cell, by the entries that it reads
  double slope;    // tan psi that a face within the reach of a tap needs for the edge to be seen
};

// Marks the doubtful cells next to steep faces: in a cell without a rim the layer changes by at most exp(T s)
// between a tap and any direction, s the stencil radius and T the largest tan psi within s of the tap.
template <class Table>
void mask_doubtful(const TriangleMesh& mesh, const std::vector<DoubtfulRim>& doubtful, Table& table) {
  std::unordered_map<std::size_t, double> slopes;  // of the taps
  double least = std::numeric_limits<double>::infinity();
  for (const DoubtfulRim& rim : doubtful) {
    least = std::min(least, rim.slope);
    for (std::size_t k = 0; k < rim.reader.taps; ++k) slopes[rim.reader.entry[k]] = 0.0;
  }
  if (doubtful.empty()) return;
  const auto& scheme = table.scheme();
  const auto& walker = scheme.walker();
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    const double slope = cone.edge_on() ? std::numeric_limits<double>::infinity() : cone.largest_slope();
    if (slope < least) continue;
    walker.visit_near(cone, scheme.stencil_radius(), [&](const DirectionRun& run) {
      for (std::size_t k = 0; k < run.count; ++k) {
        const auto tap = slopes.find(run.first + k);
        if (tap != slopes.end()) tap->second = std::max(tap->second, slope);
      }
    });
  }
  for (const DoubtfulRim& rim : doubtful) {
    for (std::size_t k = 0; k < rim.reader.taps; ++k) {
      const std::size_t entry = rim.reader.entry[k];
      if (!std::isnan(table.radius_of(entry)) && slopes[entry] >= rim.slope)
        table.mark_rim_cell(rim.reader.cell);
    }
  }
}

// Marks every cell in which the surface ends or jumps between the entries that it reads, for these of the
// jump edges of the mesh. A table is one that has radius_of(), keeps(), scheme() and a rim mask; cells that
// read an entry that it does not keep are never asked, and are left out.
template <class Table>
void mask_rim_along(const std::vector<JumpEdge>& edges, const TriangleMesh& mesh, Layer layer, Table& table) {
  const double reach = table.scheme().stencil_radius();
  std::vector<DoubtfulRim> doubtful;
  for (const JumpEdge& edge : edges) {
    const Vec3& from = mesh.vertices[edge.from];
    const Vec3& to = mesh.vertices[edge.to];
    const Vec3 across = from.cross(to);
    if (across.squaredNorm() == 0.0) continue;  // seen as a point
    for (const double side : {-kBesideEdge, kBesideEdge}) {
      const Vec3 aside = side * across.normalized();
      for_each_cell_along(table.scheme(), from + from.norm() * aside, to + to.norm() * aside,
                          [&](const Stencil& stencil, const Vec3& x) {
                            for_each_cell_reading(table.scheme(), stencil, [&](const Stencil& reader) {
                              if (!table.keeps(reader) || !may_be_parted(table, reader)) return;
                              const double change = change_to_be_seen(table, reader, x.norm(), layer);
                              if (change <= edge.slope * reach) {
                                table.mark_rim_cell(reader.cell);
                              } else {
                                doubtful.push_back({reader, change / reach});
                              }
                            });
                          });
    }
  }
  std::erase_if(doubtful, [&table](const DoubtfulRim& rim) { return table.is_rim_cell(rim.reader.cell); });
  mask_doubtful(mesh, doubtful, table);
}

// For all of them.
template <class Table>
void mask_rim(const TriangleMesh& mesh, Layer layer, Table& table) {
  mask_rim_along(jump_edges(mesh), mesh, layer, table);
}

}  // namespace impinge

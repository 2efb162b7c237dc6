// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the rim mask: finds the cells of a table that the edge of a surface crosses, by Theorem 4 (rim).
//
// It finds every cell that an edge enters by more than rounding, however the borders of cells bend. Each edge
// is followed twice, at kBesideEdge on either side, against rounding. It is halved in angle until each part
// surely meets every cell in one stretch (HasKnownBorders in sphere/scheme.hpp) or is shorter than kRimPlace:
// a border of curvature k cuts less than k kRimPlace^2 off such a part. Along a part the places where the
// cell changes are found by halving, one after the other. Only a cell that is narrower than that and runs
// along the edge may be missed; it is marked with its neighbours, which read across it.
//
// If a scheme does not declare the borders of its cells, entries beside an edge lose their surface.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include <Eigen/Geometry>

#include "mesh/jump_edges.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/walker.hpp"
#include "table/layer.hpp"

namespace impinge {

/// How far beside an edge it is followed, on either side, radians. If it runs along the border of two cells,
/// both are found.
inline constexpr double kBesideEdge = 1e-9;

/// How exactly a change of cell is located, radians: far below kBesideEdge.
inline constexpr double kRimPlace = 1e-12;

/// A piece of a straight line, and the angle between the directions of its ends.
struct RimPart {
  Vec3 first;    // mm
  Vec3 last;     // mm
  double angle;  // radians; rounded up
};

/// The cross product, each component within two units of its last place, by Kahan's difference of products
/// (Jeannerod, Louvet and Muller 2013). So the plane of two points that are nearly opposite keeps its digits.
inline Vec3 accurate_cross(const Vec3& a, const Vec3& b) {
  const auto difference = [&](Eigen::Index i, Eigen::Index k) {
    const double product = a[k] * b[i];
    return std::fma(a[i], b[k], -product) - std::fma(a[k], b[i], -product);
  };
  return {difference(1, 2), difference(2, 0), difference(0, 1)};
}

/// The unit vector across an edge, as the centre sees it; 0 if it sees the edge as one or two points.
inline Vec3 across(const Vec3& from, const Vec3& to) { return accurate_cross(from, to).stableNormalized(); }

/// The point of the line through both that is nearest to the centre, mm. If it is nearer than 1e-60 of their
/// distance it is moved out to there, so that its square does not underflow.
inline Vec3 nearest_to_centre(const Vec3& first, const Vec3& last) {
  const Vec3 along = last - first;
  const Vec3 normal = accurate_cross(first, last);
  const double radius = std::max(normal.stableNorm() / along.norm(), 1e-60 * along.norm());
  return radius * along.normalized().cross(normal.stableNormalized());
}

/// The two halves of a part. The ray that halves the angle between two points divides the line between them
/// in the ratio of their distances from the centre. If they are nearly opposite this loses its digits; then
/// the line is parted where it is nearest to the centre, not in equal angles.
inline std::array<RimPart, 2> halves(const RimPart& part) {
  const double near = part.first.norm();
  const double far = part.last.norm();
  if (part.first.dot(part.last) < -0.7 * near * far) {
    const Vec3 middle = nearest_to_centre(part.first, part.last);
    return {{{part.first, middle, angle_between(part.first, middle)},
             {middle, part.last, angle_between(middle, part.last)}}};
  }
  const Vec3 middle = (far / (near + far)) * part.first + (near / (near + far)) * part.last;
  return {{{part.first, middle, 0.5 * part.angle}, {middle, part.last, 0.5 * part.angle}}};
}

/// The line from `from` to `to`, with each of its points x moved by |x| `aside`. It must not lead through the
/// centre itself.
struct RimLine {
  Vec3 from;                  // mm
  Vec3 to;                    // mm
  Vec3 aside = Vec3::Zero();  // across, radians

  RimPart whole() const { return {from, to, angle_between(from, to)}; }  // without the move
  Vec3 moved(const Vec3& x) const { return x + x.norm() * aside; }       // where the move takes x, mm
};

/// Follows a straight line from cell to cell.
template <class S, class Visit>
class RimTrace {
 public:
  /// Keeps references to `scheme` and `visit`.
  RimTrace(const S& scheme, const RimPart& line, Visit& visit)
      : scheme_(scheme),
        line_(line),
        visit_(visit),
        entered_(line.first),
        here_(scheme.stencil(line.first)) {}

  /// Follows the line from one end to the other. To be called once.
  void run() {
    follow(line_);
    visit_(here_, entered_, line_.last);
  }

 private:
  /// Divides a part until each piece meets every cell in one stretch, or is too short to matter.
  void follow(const RimPart& part) {
    if (part.angle < kRimPlace || meets_cells_once(scheme_, part.first, part.last)) return find_changes(part);
    for (const RimPart& half : halves(part)) follow(half);
  }

  /// Finds by halving where the line leaves the cell that it is in, until the end of the part.
  void find_changes(RimPart part) {
    const std::size_t last_cell = scheme_.stencil(part.last).cell;
    while (here_.cell != last_cell) {
      RimPart change = part;
      while (change.angle > kRimPlace) {
        const auto [before, after] = halves(change);
        change = scheme_.stencil(before.last).cell == here_.cell ? after : before;
      }
      visit_(here_, entered_, change.first);
      part.first = entered_ = change.last;
      here_ = scheme_.stencil(entered_);
    }
  }

  const S& scheme_;
  RimPart line_;
  Visit& visit_;
  Vec3 entered_;  // where the line entered the cell that it is in
  Stencil here_;
};

/// Calls visit(stencil, first, last) once for each stretch of the line within one cell, in order, with the
/// ends of the stretch. No cell is left out that the line enters by more than rounding. `part` is the part of
/// the line to follow. A line that is moved aside counts as straight over an eighth of a turn at most, which
/// is no farther than 1.09 `aside` from the edge; longer parts are halved.
template <class S, class Visit>
void for_each_cell_along(const S& scheme, const RimLine& line, const RimPart& part, Visit&& visit) {
  if (part.angle > 0.25 * kPi && !line.aside.isZero(0.0)) {
    for (const RimPart& half : halves(part)) for_each_cell_along(scheme, line, half, visit);
    return;
  }
  const RimLine straight{line.moved(part.first), line.moved(part.last)};
  RimTrace<S, std::remove_reference_t<Visit>>(scheme, straight.whole(), visit).run();
}
/// The same along the whole line.
template <class S, class Visit>
void for_each_cell_along(const S& scheme, const RimLine& line, Visit&& visit) {
  for_each_cell_along(scheme, line, line.whole(), visit);
}

/// The least distance of a stretch of a line from the centre, mm.
inline double least_radius(const Vec3& first, const Vec3& last) {
  const Vec3 along = last - first;
  const double length = along.squaredNorm();
  if (length == 0.0) return first.norm();
  return (first + std::clamp(-first.dot(along) / length, 0.0, 1.0) * along).norm();
}
/// The largest distance, which is at an end, mm.
inline double largest_radius(const Vec3& first, const Vec3& last) {
  return std::max(first.norm(), last.norm());
}
/// Of these two the distance, mm, at which a stretch is most likely to belong to the layer.
inline double radius_to_be_seen(const Vec3& first, const Vec3& last, Layer layer) {
  return layer == Layer::nearest ? least_radius(first, last) : largest_radius(first, last);
}

/// By how much ln r must change from some filled tap to the edge if the edge is to belong to the layer: the
/// least over the taps, 0 or less if no change is needed. `radius` is the radius of the edge in the cell, mm.
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

/// Calls visit(stencil) for the cells that may read a tap across the cell of `at`: this cell and, if the taps
/// of the scheme reach beyond the corners of a cell, the cells of its for_each_cell_across().
template <class S, class Visit>
void for_each_cell_reading(const S& scheme, const Stencil& at, Visit&& visit) {
  visit(at);
  if constexpr (requires { scheme.for_each_cell_across(at, visit); }) scheme.for_each_cell_across(at, visit);
}

/// Does the cell read two or more filled entries, which a rim could separate? (One alone is not mixed with
/// anything; an empty entry silences its cell, but not on the line between two others.) Also true for a cell
/// that reads one entry only, which would answer beyond the rim too.
template <class Table>
bool may_be_parted(const Table& table, const Stencil& stencil) {
  return std::count_if(stencil.entry.begin(), stencil.entry.begin() + stencil.taps,
                       [&](std::size_t i) { return !std::isnan(table.radius_of(i)); }) > 1 ||
         stencil.taps == 1;
}

/// An edge in a cell that seems hidden behind the layer, judged by the faces at the edge alone.
struct DoubtfulRim {
  Stencil reader;  // of the cell
  double slope;    // the edge is seen only if a face within reach of a tap has this tan psi
};

/// Marks the doubtful cells next to steep faces. In a cell without a rim the layer changes by at most exp(T
/// s) between a tap and any direction, s the stencil radius and T the largest tan psi within s of the tap.
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
  const auto& walker = walker_of(scheme);
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    const double slope = cone.edge_on() ? std::numeric_limits<double>::infinity() : cone.largest_slope();
    if (slope < least) continue;
    for_each_entry_near(walker, cone, scheme.stencil_radius(), [&](std::size_t entry, const Vec3&) {
      const auto tap = slopes.find(entry);
      if (tap != slopes.end()) tap->second = std::max(tap->second, slope);
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

/// For a scheme that does not declare the borders of its cells: takes the surface from every entry within the
/// stencil radius of an edge. As no direction reads an entry farther away than that, none reads across an
/// edge.
template <class Table>
void forget_beside(const std::vector<JumpEdge>& edges, const TriangleMesh& mesh, Table& table) {
  const auto& walker = walker_of(table.scheme());
  const double reach = table.scheme().stencil_radius() + kBesideEdge;
  for (const JumpEdge& edge : edges) {
    for_each_entry_near(walker, cone_of(mesh, edge), reach,
                        [&](std::size_t entry, const Vec3&) { table.forget(entry); });
  }
}

/// Marks the cells that the line along one side of an edge parts, or adds them to `doubtful`.
template <class Table>
void mask_along(const JumpEdge& edge, const RimLine& line, Layer layer, Table& table,
                std::vector<DoubtfulRim>& doubtful) {
  const double reach = table.scheme().stencil_radius();
  for_each_cell_along(table.scheme(), line, [&](const Stencil& at, const Vec3& first, const Vec3& last) {
    const double radius = radius_to_be_seen(first, last, layer);
    for_each_cell_reading(table.scheme(), at, [&](const Stencil& reader) {
      if (!table.keeps(reader) || !may_be_parted(table, reader)) return;
      const double change = change_to_be_seen(table, reader, radius, layer);
      if (change <= edge.slope * reach) {
        table.mark_rim_cell(reader.cell);
      } else {
        doubtful.push_back({reader, change / reach});
      }
    });
  });
}

/// Calls visit(edge, line) for both sides of each edge, except edges that the centre sees as one or two
/// points.
template <class Visit>
void for_each_side(const std::vector<JumpEdge>& edges, const TriangleMesh& mesh, Visit&& visit) {
  for (const JumpEdge& edge : edges) {
    RimLine line{mesh.vertices[edge.from], mesh.vertices[edge.to]};
    const Vec3 normal = across(line.from, line.to);
    if (normal.isZero(0.0)) continue;
    for (const double side : {-kBesideEdge, kBesideEdge}) {
      line.aside = side * normal;
      visit(edge, line);
    }
  }
}

/// Marks the cells that these edges part and those that read across them.
template <class Table>
void mask_crossed(const std::vector<JumpEdge>& edges, const TriangleMesh& mesh, Layer layer, Table& table) {
  std::vector<DoubtfulRim> doubtful;
  for_each_side(edges, mesh, [&](const JumpEdge& edge, const RimLine& line) {
    mask_along(edge, line, layer, table, doubtful);
  });
  std::erase_if(doubtful, [&table](const DoubtfulRim& rim) { return table.is_rim_cell(rim.reader.cell); });
  mask_doubtful(mesh, doubtful, table);
}

/// Marks every cell in which the surface ends or jumps, at these of the jump edges of the mesh, between the
/// entries that the cell reads. `Table` has radius_of(), keeps(), forget(), scheme() and a rim mask. Cells
/// that read an entry that it does not keep are left out.
template <class Table>
void mask_rim_along(const std::vector<JumpEdge>& edges, const TriangleMesh& mesh, Layer layer, Table& table) {
  const auto& scheme = table.scheme();
  if constexpr (requires { scheme.has_known_borders(); }) {  // AnyScheme
    scheme.has_known_borders() ? mask_crossed(edges, mesh, layer, table) : forget_beside(edges, mesh, table);
  } else if constexpr (HasKnownBorders<std::remove_cvref_t<decltype(scheme)>>) {
    mask_crossed(edges, mesh, layer, table);
  } else {
    forget_beside(edges, mesh, table);
  }
}

/// The same for all jump edges of the mesh.
template <class Table>
void mask_rim(const TriangleMesh& mesh, Layer layer, Table& table) {
  mask_rim_along(jump_edges(mesh), mesh, layer, table);
}

}  // namespace impinge

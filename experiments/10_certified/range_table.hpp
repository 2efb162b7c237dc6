// SPDX-License-Identifier: GPL-3.0-or-later
// Where the true surface surely lies in each cell of a scheme.
//
// A cell is known by the entries that a look-up in it reads, and a direction is within the stencil radius s
// of each of them. So every entry keeps the range of all radii of the mesh within s of it, and a look-up
// answers with what the ranges of its taps have in common: each holds the radius along u, in every cell and
// for every interpolant. Where the surface slopes by |grad r| the common range of four taps at the corners of
// a cell is about 1.6 |grad r| times their spacing wide, against 1 to 1.4 for the cell itself: little is
// lost.
//
// Whether there is a surface at all is told as well. A cap that no jump edge enters and whose axis meets the
// surface is covered whole (jump_sides()); one that no face enters is not covered anywhere.
//
// Where the surface has several layers the range holds all of them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "10_certified/face_range.hpp"
#include "mesh/lengths.hpp"
#include "sphere/cell_mask.hpp"
#include "sphere/table_size.hpp"
#include "sphere/walker.hpp"

namespace impinge::lab {

/// Every radius of the surface along a direction is within `range`; there is none with Cover::none, at least
/// one with Cover::whole.
struct SurfaceRange {
  RadiusRange range;          // mm; empty with Cover::none
  Cover cover = Cover::none;  // of the cell that holds the direction
};

/// Ranges in mm as floats, rounded outwards: 8 bytes an entry and two bits.
template <SamplingScheme S>
class RangeTable {
 public:
  /// Without any surface. std::invalid_argument above kMostTableEntries.
  explicit RangeTable(const S& scheme)
      : scheme_(scheme),
        ranges_(require_table_size(S::name, scheme.size())),
        met_(scheme.size()),
        cut_(scheme.size()) {}

  const S& scheme() const { return scheme_; }  // whose entries have the ranges
  /// Memory of ranges and bits.
  std::size_t bytes() const { return ranges_.size() * sizeof(FloatRange) + 2 * (ranges_.size() / 8); }

  /// What is known of the radius along x, of any length above zero.
  SurfaceRange at(const Vec3& x) const {
    const Stencil stencil = scheme_.stencil(x);
    SurfaceRange common{{0.0, std::numeric_limits<double>::infinity()}, Cover::part};
    for (std::size_t k = 0; k < stencil.taps; ++k) {
      const std::size_t i = stencil.entry[k];
      common.range.low = std::max(common.range.low, static_cast<double>(ranges_[i].low));
      common.range.high = std::min(common.range.high, static_cast<double>(ranges_[i].high));
      if (met_.contains(i) && !cut_.contains(i)) common.cover = Cover::whole;
    }
    if (common.range.empty()) return {};
    return common;
  }

  /// Widens the range of an entry to hold another one.
  void include(std::size_t entry, const RadiusRange& range) {
    const auto low = static_cast<float>(range.low);
    const auto high = static_cast<float>(range.high);
    FloatRange& kept = ranges_[entry];
    kept.low = std::min(kept.low, std::nextafter(low, 0.0F));
    kept.high = std::max(kept.high, std::nextafter(high, std::numeric_limits<float>::infinity()));
  }
  void mark_met(std::size_t entry) { met_.mark(entry); }  // the surface covers the direction of the entry
  void mark_cut(std::size_t entry) { cut_.mark(entry); }  // a jump edge may enter its cap

 private:
  struct FloatRange {
    float low = std::numeric_limits<float>::infinity();
    float high = -std::numeric_limits<float>::infinity();
  };

  S scheme_;
  std::vector<FloatRange> ranges_;
  CellMask met_;
  CellMask cut_;
};

/// What one face says about the cap of one entry.
template <SamplingScheme S>
void include_face(RangeTable<S>& table, std::size_t entry, const FaceInCap& part,
                  const std::array<bool, 3>& jumps) {
  table.include(entry, part.range);
  for (std::size_t k = 0; k < 3; ++k) {
    if (jumps[k] && part.side_inside[k]) table.mark_cut(entry);
  }
}

/// For each face, whether its side from corner k to corner k + 1 is one of jump_edges(). Where no such side
/// is near, the surface goes on: a set of directions that is connected, meets the surface and no jump edge is
/// covered by it whole. For were it not, the surface would end in it at an edge of a face, or at a corner
/// round which the faces do not close. mesh in the centre frame.
std::vector<std::array<bool, 3>> jump_sides(const TriangleMesh& mesh);

/// mesh in the centre frame; faces whose plane holds the centre cover no direction and are left out, as in a
/// radial table.
template <SamplingScheme S>
RangeTable<S> fill_ranges(const TriangleMesh& mesh, const S& scheme) {
  require_lengths(mesh);
  RangeTable<S> table(scheme);
  const auto& walker = walker_of(scheme);
  const auto jumps = jump_sides(mesh);
  const double reach = scheme.stencil_radius();
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const TriangleCone cone = cone_of(mesh, mesh.faces[f]);
    if (cone.edge_on()) continue;
    const FaceRange face(cone);
    const double margin = reach * (1.0 + 2.0 * kCapShare) + 2.0 * kCapSlack;
    for_each_entry_near(walker, cone, margin, [&](std::size_t entry, const Vec3& u) {
      const auto part = face.in_cap({u, reach});
      if (!part) return;
      include_face(table, entry, *part, jumps[f]);
      if (cone.contains(u)) table.mark_met(entry);
    });
  }
  return table;
}

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// A radial table that keeps only some entries of its scheme: those that will be read. The others take no
// memory and are never worked out. If all entries that a look-up reads are kept, it answers as the full table
// does, bit for bit, rim cells included; else it answers kNoSurface.
#pragma once

#include <cstddef>
#include <unordered_set>
#include <vector>

#include "sphere/any_scheme.hpp"
#include "sphere/entry_set.hpp"
#include "sphere/radial_table.hpp"
#include "table/near_faces.hpp"

namespace impinge {

class PartialTable {
 public:
  /// A table in which no entry has a surface yet. The set must have been numbered (EntrySet::number()).
  PartialTable(AnyScheme scheme, EntrySet entries);

  const AnyScheme& scheme() const { return scheme_; }  // some of whose entries are kept
  const EntrySet& kept() const { return kept_; }       // the entries that have a radius here
  double radius_of(std::size_t entry) const;           // mm, kNoSurface if it is not kept
  /// Sets the radius of the entry with this slot of kept(), mm.
  void set(std::size_t slot, double radius) { radii_[slot] = radius; }
  /// The entry has no surface from now on.
  void forget(std::size_t entry) {
    if (const auto slot = kept_.slot(entry)) set(*slot, kNoSurface);
  }
  bool keeps(const Stencil& stencil) const;  // are all entries kept that this stencil reads?

  /// Does this cell answer kNoSurface?
  bool is_rim_cell(std::size_t cell) const { return !rim_.empty() && rim_.contains(cell); }
  void mark_rim_cell(std::size_t cell) { rim_.insert(cell); }  // from now on this cell answers kNoSurface

  double radius_at(const Vec3& x) const;  // mm, kNoSurface if it has no answer
  std::size_t bytes() const;              // of memory

 private:
  AnyScheme scheme_;
  EntrySet kept_;
  std::vector<double> radii_;
  std::unordered_set<std::size_t> rim_;
};

/// Adds the entries that a look-up along x reads.
void insert_taps(const AnyScheme& scheme, const Vec3& x, EntrySet& entries);

/// A table with the radii of fill_exact() at the entries of the set. It looks at the faces near each entry,
/// in O(entries of the set); fill_exact() takes O(faces + all entries). `faces` may have any margin.
PartialTable fill_partial(const NearFaces& faces, const AnyScheme& scheme, EntrySet entries, Layer layer);

/// An edge that marks a cell is within kRimReach stencil radii of the entries that the cell reads. An edge
/// marks the cells that it crosses and those that read across these, and two directions of a cell, or between
/// the entries that it reads, are at most two stencil radii apart.
inline constexpr double kRimReach = 4.0;

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// The radial table, the thesis' look-up table: one radius for each entry of a scheme.
#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "sphere/cell_mask.hpp"
#include "sphere/interpolate.hpp"
#include "sphere/table_memory.hpp"
#include "sphere/table_size.hpp"

namespace impinge {

/// The radius where there is no surface. It is a NaN, so that no comparison calls it a hit, and any
/// interpolation that reads it says "no surface" too.
inline constexpr double kNoSurface = std::numeric_limits<double>::quiet_NaN();

/// Radii in mm. Rim cells, in which the surface ends or jumps, answer kNoSurface: no tap reaches across a
/// rim.
template <SamplingScheme S>
class RadialTable {
 public:
  /// A table without any surface. Throws std::invalid_argument for more than kMostTableEntries entries,
  /// std::bad_alloc if it does not fit in memory; see bytes().
  explicit RadialTable(const S& scheme)
      : scheme_(scheme),
        radii_(require_table_size(S::name, scheme.size()), kNoSurface),
        rim_(scheme.cells()) {}

  const S& scheme() const { return scheme_; }                // whose entries have the radii
  std::span<const double> radii() const& { return radii_; }  // mm, by entry; kNoSurface where there is none
  std::span<double> radii() & { return radii_; }
  std::span<const double> radii() const&& = delete;                    // they would dangle: keep the table
  double radius_of(std::size_t entry) const { return radii_[entry]; }  // of an entry, mm
  void forget(std::size_t entry) { radii_[entry] = kNoSurface; }       // it has no surface from now on
  static bool keeps(const Stencil& /*stencil*/) { return true; }  // does it keep the entries of the stencil?

  /// Bytes of the radii of a table of this scheme (thesis, Tables 2 and 7), without making one. If any cell
  /// is a rim cell, the rim mask adds one bit for each cell.
  static std::size_t bytes(const S& scheme) { return scheme.size() * sizeof(double); }

  /// Bytes of radii and rim mask.
  std::size_t bytes() const { return bytes(scheme_) + rim_.bytes(); }

  /// Interpolated radius along x (any length above zero), mm, or kNoSurface. This is the `smooth`
  /// interpolant: linear in r, as in the thesis.
  double radius_at(const Vec3& x) const {
    const Stencil stencil = scheme_.stencil(x);
    return is_rim_cell(stencil.cell) ? kNoSurface : interpolate(stencil, radii_);
  }

  /// Does this cell answer kNoSurface?
  bool is_rim_cell(std::size_t cell) const { return rim_.contains(cell); }
  void mark_rim_cell(std::size_t cell) { rim_.mark(cell); }  // from now on this cell answers kNoSurface
  void forget_rim() { rim_ = CellMask(scheme_.cells()); }    // unmarks all cells
  const CellMask& rim_cells() const { return rim_; }         // the cells that are marked

 private:
  S scheme_;
  TableMemory<double> radii_;
  CellMask rim_;
};

}  // namespace impinge

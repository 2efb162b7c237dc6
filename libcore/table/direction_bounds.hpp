// SPDX-License-Identifier: GPL-3.0-or-later
// A proven bound on the error of one look-up. It is the least of
//   the bound of first order about the direction (error_bound.hpp), for tables of radii,
//   the bound of the cell that answers, before any halving (table_bound.hpp), if the scheme has patches,
//   and the bound of the whole table (table_bound.hpp).
// A face that is seen edge-on somewhere spoils only the last of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "table/own_scheme.hpp"

namespace impinge {

/// Tables of radii with more cells get only the bound of first order: the others take microseconds a cell.
inline constexpr std::size_t kMostBoundedCells = 1'500'000;

/// The lesser of the bound of a cell and the bound of the whole table, mm. A 0 in `of_cells` means that the
/// cell has no bound of its own.
inline double bound_in(const std::vector<float>& of_cells, std::size_t cell, double everywhere) {
  const auto here = static_cast<double>(of_cells[cell]);
  return here > 0.0 ? std::min(here, everywhere) : everywhere;
}

/// The bounds of a RadialTable of any scheme.
template <SamplingScheme S>
class DirectionBounds {
 public:
  /// The table must have been filled exactly, for this layer, from `mesh`, which is in the centre frame.
  /// Keeps a reference to the table. `options` control the search for the bound of the whole table.
  DirectionBounds(const TriangleMesh& mesh, const RadialTable<S>& table, Layer layer,
                  BoundOptions options = {})
      : table_(table), slopes_(largest_slopes(mesh, table.scheme())) {
    if (table.scheme().cells() > kMostBoundedCells) return;
    if constexpr (HasPatches<S>) {
      cells_.resize(table.scheme().cells());
      options.of_cells = &cells_;
    }
    everywhere_ = table_bound(mesh, table, layer, options).bound_mm;
  }

  DirectionBounds(const TriangleMesh&, const RadialTable<S>&&, Layer, BoundOptions = {}) = delete;

  /// Bound for the whole table, mm; infinite if none is proven.
  double everywhere() const { return everywhere_; }

  /// Bound on |radius_at(x) - radius of the mesh along x|, mm; kNoSurface if the table has no answer,
  /// infinite if nothing is proven.
  double at(const Vec3& x) const {
    const double here = error_bound_at(table_, slopes_, x);
    if (std::isnan(here)) return here;
    const double all = std::min(here, everywhere_);
    return cells_.empty() ? all : bound_in(cells_, table_.scheme().stencil(x).cell, all);
  }

 private:
  const RadialTable<S>& table_;
  std::vector<float> slopes_;
  std::vector<float> cells_;  // mm
  double everywhere_ = HUGE_VAL;
};

/// The bounds of an InverseDepthTable.
template <PlaneExactScheme S>
class FlatDirectionBounds {
 public:
  /// As in DirectionBounds.
  FlatDirectionBounds(const TriangleMesh& mesh, const InverseDepthTable<S>& table, Layer layer,
                      BoundOptions options = {})
      : table_(table) {
    if constexpr (HasFlatPatches<S>) {
      cells_.resize(table.scheme().cells());
      options.of_cells = &cells_;
    }
    everywhere_ = table_bound(mesh, table, layer, options).bound_mm;
  }

  FlatDirectionBounds(const TriangleMesh&, const InverseDepthTable<S>&&, Layer, BoundOptions = {}) = delete;

  double everywhere() const { return everywhere_; }  // as in DirectionBounds

  /// As in DirectionBounds.
  double at(const Vec3& x) const {
    if (std::isnan(table_.radius_at(x))) return kNoSurface;
    if (cells_.empty()) return everywhere_;
    return bound_in(cells_, table_.scheme().plane_stencil(x).cell, everywhere_);
  }

 private:
  const InverseDepthTable<S>& table_;
  std::vector<float> cells_;  // mm
  double everywhere_ = HUGE_VAL;
};

}  // namespace impinge

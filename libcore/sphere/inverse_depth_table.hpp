// SPDX-License-Identifier: GPL-3.0-or-later
// The table behind the `mesh_exact` interpolant: 1 / depth for each entry of a scheme that lies on a solid.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sphere/cell_mask.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

/// Does a rim cross the triangle of the taps, or part x from them? If it does not cross the cell of the taps
/// it can only cut off what lies beside its curved border, in the cell of x.
template <PlaneExactScheme S>
bool is_at_rim(const S& scheme, const CellMask& rim, std::size_t taps_cell, const Vec3& x) {
  if (rim.empty()) return false;
  if constexpr (!S::kFlatCells) {
    if (rim.contains(scheme.stencil(x).cell)) return true;
  }
  return rim.contains(taps_cell);
}

/// The look-up in inverse depths, however they are kept: radius along x (any length above zero), mm.
template <PlaneExactScheme S, class Values>
double plane_exact_radius_at(const S& scheme, const CellMask& rim, const Values& inverse_depths,
                             const Vec3& x) {
  const Stencil stencil = scheme.plane_stencil(x);
  if (is_at_rim(scheme, rim, stencil.cell, x)) return kNoSurface;
  return (x / scheme.depth(x)).norm() / interpolate(stencil, inverse_depths);
}

/// P(u) = u / depth(u) is the point of the scheme's solid (cube, icosahedron) along a direction u. The plane
/// n . x = d has radius r = d / (n . u), so that
///   1 / (r depth(u)) = n . P(u) / d
/// is linear in P on each face of the solid, and weights with P(x) = sum w_i P(u_i) reproduce it: exact on a
/// flat face that covers the cell, at any incidence angle. (In graphics, perspective-correct interpolation.)
/// A sphere of radius R becomes its chords: up to R rho^2 / 2 inside of it, rho the covering radius, where
/// the `smooth` interpolant of RadialTable is exact.
template <PlaneExactScheme S>
class InverseDepthTable {
 public:
  /// From a filled table, whose rim cells it takes over. 1 / mm.
  explicit InverseDepthTable(const RadialTable<S>& table)
      : scheme_(table.scheme()), rim_(table.rim_cells()), inverse_depths_(scheme_.size()) {
    const auto radii = table.radii();
    for (std::size_t i = 0; i < radii.size(); ++i)
      inverse_depths_[i] = 1.0 / (radii[i] * scheme_.depth(scheme_.direction(i)));
  }

  const S& scheme() const { return scheme_; }  // whose entries it keeps

  /// Those of the radii: one double an entry.
  static std::size_t bytes(const S& scheme) { return RadialTable<S>::bytes(scheme); }

  /// 1 / mm, NaN where there is no surface.
  std::span<const double> inverse_depths() const& { return inverse_depths_; }
  std::span<const double> inverse_depths() const&& = delete;  // they would dangle: keep the table
  const CellMask& rim_cells() const { return rim_; }          // cells that answer kNoSurface

  /// Interpolated radius along x (any length above zero), mm; kNoSurface as in RadialTable::radius_at().
  double radius_at(const Vec3& x) const { return plane_exact_radius_at(scheme_, rim_, inverse_depths_, x); }

 private:
  S scheme_;
  CellMask rim_;
  std::vector<double> inverse_depths_;  // 1 / (r_i depth(u_i)), NaN where there is no surface
};

}  // namespace impinge

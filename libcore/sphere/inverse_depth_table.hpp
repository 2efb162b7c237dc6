// SPDX-License-Identifier: GPL-3.0-or-later
// The table behind the `mesh_exact` interpolant: 1 / depth for each entry of a scheme that lies on a solid.
#pragma once

#include <cstddef>
#include <vector>

#include "sphere/cell_mask.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

// P(u) = u / depth(u) is the point of the scheme's solid (cube, icosahedron) along a direction u. The plane
// n . x = d has radius r = d / (n . u), so that
//   1 / (r depth(u)) = n . P(u) / d
// is linear in P on each face of the solid, and weights with P(x) = sum w_i P(u_i) reproduce it: exact on a
// flat face that covers the cell, at any incidence angle. (In graphics, perspective-correct interpolation.)
// A sphere of radius R becomes its chords: up to R rho^2 / 2 inside of it, rho the covering radius, where the
// `smooth` interpolant of RadialTable is exact.
template <PlaneExactScheme S>
class InverseDepthTable {
 public:
  // From a filled table, whose rim cells it takes over. 1 / mm.
  explicit InverseDepthTable(const RadialTable<S>& table)
      : scheme_(table.scheme()), rim_(table.rim_cells()), inverse_depths_(scheme_.size()) {
    const auto radii = table.radii();
    for (std::size_t i = 0; i < radii.size(); ++i)
      inverse_depths_[i] = 1.0 / (radii[i] * scheme_.depth(scheme_.direction(i)));
  }

  const S& scheme() const { return scheme_; }

  static std::size_t bytes(const S& scheme) { return RadialTable<S>::bytes(scheme); }

  // Interpolated radius along x (any length above zero), mm; kNoSurface as in RadialTable::radius_at().
  double radius_at(const Vec3& x) const {
    const Stencil stencil = scheme_.plane_stencil(x);
    if (is_at_rim(stencil.cell, x)) return kNoSurface;
    double inverse_depth = 0.0;
    for (std::size_t k = 0; k < stencil.taps; ++k) {
      // A tap of weight zero does not count: on an entry the entry alone decides.
      if (stencil.weight[k] > 0.0) inverse_depth += stencil.weight[k] * inverse_depths_[stencil.entry[k]];
    }
    return (x / scheme_.depth(x)).norm() / inverse_depth;
  }

 private:
  // Does a rim cross the triangle of the taps, or part x from them? If it does not cross the cell of the taps
  // it can only cut off what lies beside its curved border, in the cell of x.
  bool is_at_rim(std::size_t taps_cell, const Vec3& x) const {
    if (rim_.empty()) return false;
    if constexpr (!S::kFlatCells) {
      if (rim_.contains(scheme_.stencil(x).cell)) return true;
    }
    return rim_.contains(taps_cell);
  }

  S scheme_;
  CellMask rim_;
  std::vector<double> inverse_depths_;  // 1 / (r_i depth(u_i)), NaN where there is no surface
};

}  // namespace impinge

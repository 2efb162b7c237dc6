// SPDX-License-Identifier: GPL-3.0-or-later
// Tables kept in fewer bytes: those of radii (`smooth`) and of inverse depths (`mesh_exact`), in float or in
// 16 bits over the occupied range. They answer as the table in double that they are made from, rim cells
// included, up to a bound that is worked out when they are made.
//
// Radii. Weights are not negative and sum to 1, so that an answer is off by at most as much as an entry is:
//   |sum w_i R_i - sum w_i r_i| <= max |R_i - r_i|                      (half a step, or 2^-24 r in float)
// Inverse depths. The radius is |P| / q, P the point of the solid and q = sum w_i q_i. With e the largest
// |Q_i - q_i| / Q_i,
//   | |P| / Q - |P| / q | = (|P| / q) |sum w_i (Q_i - q_i)| / sum w_i Q_i <= r e,
// a mean of quotients being none larger than the largest. With one error d of every entry this is the
// r^2 depth d that the derivative of 1 / (q depth) gives. And r <= max r_i, since |P| <= sum w_i |P_i| and
// q_i = |P_i| / r_i.
// The maxima run over the entries as they are stored, so that neither bound is larger than it must be. Added
// is the rounding of the two sums of at most four products, and of the weights' sum: kSumRounding times r.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sphere/inverse_depth_table.hpp"
#include "sphere/stored_values.hpp"

namespace impinge {

/// 5 roundings of either sum, 4 of the weights' sums, 3 of point and quotient; half an ulp each.
inline constexpr double kSumRounding = 17.0 * 0x1p-53;

/// Radii of a RadialTable, kept in `Values` (see stored_values.hpp).
template <SamplingScheme S, class Values>
class StoredRadialTable {
 public:
  /// Rounds the radii of a table, and finds by how much. std::invalid_argument where `Values` cannot keep
  /// them.
  explicit StoredRadialTable(const RadialTable<S>& table)
      : scheme_(table.scheme()), rim_(table.rim_cells()), values_(table.radii()) {
    double off = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const double radius = table.radii()[i];
      if (std::isnan(radius)) continue;
      off = std::max(off, std::abs(values_[i] - radius));
      largest = std::max(largest, radius);
    }
    storage_bound_ = off + kSumRounding * largest;
  }

  const S& scheme() const { return scheme_; }                           // whose entries it keeps
  const CellMask& rim_cells() const { return rim_; }                    // cells that answer kNoSurface
  std::size_t bytes() const { return values_.bytes() + rim_.bytes(); }  // of values and rim mask

  /// Largest |this - table in double| over all directions that have an answer, mm.
  double storage_bound() const { return storage_bound_; }

  /// Radius along direction(i), mm.
  double entry_radius(std::size_t i) const { return values_[i]; }

  /// As RadialTable::radius_at(), mm.
  double radius_at(const Vec3& x) const {
    const Stencil stencil = scheme_.stencil(x);
    return rim_.contains(stencil.cell) ? kNoSurface : interpolate(stencil, values_);
  }

 private:
  S scheme_;
  CellMask rim_;
  Values values_;
  double storage_bound_ = 0.0;
};

/// Inverse depths of an InverseDepthTable, kept in `Values`.
template <PlaneExactScheme S, class Values>
class StoredInverseDepthTable {
 public:
  /// Rounds the inverse depths of a table, as StoredRadialTable does radii.
  explicit StoredInverseDepthTable(const InverseDepthTable<S>& table)
      : scheme_(table.scheme()), rim_(table.rim_cells()), values_(table.inverse_depths()) {
    double off = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const double inverse = table.inverse_depths()[i];
      if (std::isnan(inverse)) continue;
      off = std::max(off, std::abs(values_[i] - inverse) / values_[i]);
      largest = std::max(largest, 1.0 / (inverse * scheme_.depth(scheme_.direction(i))));
    }
    storage_bound_ = largest * (off + kSumRounding);
  }

  const S& scheme() const { return scheme_; }                           // whose entries it keeps
  const CellMask& rim_cells() const { return rim_; }                    // cells that answer kNoSurface
  std::size_t bytes() const { return values_.bytes() + rim_.bytes(); }  // of values and rim mask

  /// Largest |this - table in double| over all directions that have an answer, mm.
  double storage_bound() const { return storage_bound_; }

  /// Radius along direction(i), mm.
  double entry_radius(std::size_t i) const {
    return 1.0 / (values_[i] * scheme_.depth(scheme_.direction(i)));
  }

  /// As InverseDepthTable::radius_at(), mm.
  double radius_at(const Vec3& x) const { return plane_exact_radius_at(scheme_, rim_, values_, x); }

 private:
  S scheme_;
  CellMask rim_;
  Values values_;
  double storage_bound_ = 0.0;
};

/// Radii in float: 4 bytes an entry.
template <SamplingScheme S>
using FloatTable = StoredRadialTable<S, FloatValues>;
/// Radii in steps of 16 bits: 2 bytes an entry.
template <SamplingScheme S>
using Uint16Table = StoredRadialTable<S, Uint16Values>;
/// Inverse depths in float.
template <PlaneExactScheme S>
using FloatInverseDepthTable = StoredInverseDepthTable<S, FloatValues>;
/// Inverse depths in steps of 16 bits.
template <PlaneExactScheme S>
using Uint16InverseDepthTable = StoredInverseDepthTable<S, Uint16Values>;

}  // namespace impinge

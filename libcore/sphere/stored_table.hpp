// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A filled table in the form in which it is kept. The interpolant says which number an entry holds, a radius
/// (`smooth`) or an inverse depth (`mesh_exact`); the values say in how many bytes: double, float, or 16 bits
/// over the occupied range. The table answers as the same interpolant in double does, rim cells included, up
/// to a bound that is found when it is made: the largest error of a stored radius, or the largest radius
/// times the largest relative error of a stored inverse depth (see the remark after Theorem 2 (table)).
/// kSumRounding times the radius is added.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

#include "sphere/cell_mask.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/stored_values.hpp"

namespace impinge {

/// The relative rounding of a look-up: 5 roundings of each of the two sums of products, 4 of the sums of
/// weights, 3 of point and quotient; half an ulp each.
inline constexpr double kSumRounding = 17.0 * 0x1p-53;

/// The `smooth` interpolant: an entry holds its radius, mm, and a look-up is linear in it, as in the thesis.
struct Smooth {
  /// The number that an entry of this radius (mm) holds.
  template <SamplingScheme S>
  static double number(const S& /*scheme*/, std::size_t /*entry*/, double radius) {
    return radius;
  }
  /// The radius of an entry that holds this number, mm.
  template <SamplingScheme S>
  static double radius(const S& /*scheme*/, std::size_t /*entry*/, double number) {
    return number;
  }
  /// Radius along x (any length above zero), mm.
  template <SamplingScheme S, class Values>
  static double radius_at(const S& scheme, const CellMask& rim, const Values& radii, const Vec3& x) {
    const Stencil stencil = scheme.stencil(x);
    return rim.contains(stencil.cell) ? kNoSurface : interpolate(stencil, radii);
  }
  /// Bound on the error of answers, mm, if entries are off by at most `off`, and by at most `relative` times
  /// what is stored.
  static double storage_bound(double off, double /*relative*/, double largest_radius) {
    return off + kSumRounding * largest_radius;
  }
};

/// May a rim cross the triangle of the taps, or part x from them? Then it crosses the cell of the taps or, if
/// x is beside the curved border of that cell, the cell of x.
template <PlaneExactScheme S>
bool is_at_rim(const S& scheme, const CellMask& rim, std::size_t taps_cell, const Vec3& x) {
  if (rim.empty()) return false;
  if constexpr (!S::kFlatCells) {
    if (rim.contains(scheme.stencil(x).cell)) return true;
  }
  return rim.contains(taps_cell);
}

/// The `mesh_exact` interpolant: an entry holds its inverse depth, 1 / mm.
///
/// P(u) = u / depth(u) is the point of the scheme's solid (cube, icosahedron) along a direction u. The plane
/// n . x = d has radius r = d / (n . u), so that
///   1 / (r depth(u)) = n . P(u) / d
/// is linear in P on each face of the solid, and weights with P(x) = sum w_i P(u_i) reproduce it: exact on a
/// flat face that covers the cell, at any incidence angle. (In graphics, perspective-correct interpolation.)
/// A sphere of radius R becomes its chords: up to R rho^2 / 2 inside of it, rho the covering radius, where
/// `smooth` is exact.
struct MeshExact {
  /// As in Smooth.
  template <PlaneExactScheme S>
  static double number(const S& scheme, std::size_t entry, double radius) {
    return 1.0 / (radius * scheme.depth(scheme.direction(entry)));
  }
  template <PlaneExactScheme S>
  static double radius(const S& scheme, std::size_t entry, double number) {
    return 1.0 / (number * scheme.depth(scheme.direction(entry)));
  }
  template <PlaneExactScheme S, class Values>
  static double radius_at(const S& scheme, const CellMask& rim, const Values& inverse_depths, const Vec3& x) {
    const Stencil stencil = scheme.plane_stencil(x);
    if (is_at_rim(scheme, rim, stencil.cell, x)) return kNoSurface;
    return (x / scheme.depth(x)).norm() / interpolate(stencil, inverse_depths);
  }
  static double storage_bound(double /*off*/, double relative, double largest_radius) {
    return largest_radius * (relative + kSumRounding);
  }
};

/// A table as it is kept, made from a filled one, whose rim cells it takes over.
template <SamplingScheme S, class Interpolant, class Values>
class StoredTable {
 public:
  /// Rounds the numbers to what `Values` can hold, and finds the error. Throws std::invalid_argument for a
  /// number that `Values` cannot hold.
  explicit StoredTable(const RadialTable<S>& filled) : StoredTable(filled, numbers_of(filled)) {}

  const S& scheme() const { return scheme_; }         // whose entries it keeps
  const CellMask& rim_cells() const { return rim_; }  // cells that answer kNoSurface
  const Values& values() const& { return values_; }   // by entry, NaN where there is no surface
  const Values& values() const&& = delete;            // they would dangle: keep the table

  /// Bytes of values and rim mask.
  std::size_t bytes() const {
    if constexpr (kExact)
      return values_.size() * sizeof(double) + rim_.bytes();
    else
      return values_.bytes() + rim_.bytes();
  }

  /// Bound on the difference from the same interpolant in double, in all directions that have an answer, mm.
  double storage_bound() const { return storage_bound_; }

  /// Radius along direction(i), mm.
  double radius_of(std::size_t i) const { return Interpolant::radius(scheme_, i, values_[i]); }

  /// Interpolated radius along x (any length above zero), mm; kNoSurface as in RadialTable::radius_at().
  double radius_at(const Vec3& x) const { return Interpolant::radius_at(scheme_, rim_, values_, x); }

 private:
  StoredTable(const RadialTable<S>& filled, const std::vector<double>& numbers)
      : scheme_(filled.scheme()), rim_(filled.rim_cells()), values_(numbers) {
    if constexpr (!kExact) find_storage_bound(numbers);
  }

  static constexpr bool kExact = std::same_as<Values, std::vector<double>>;

  static std::vector<double> numbers_of(const RadialTable<S>& filled) {
    std::vector<double> numbers(filled.radii().begin(), filled.radii().end());
    for (std::size_t i = 0; i < numbers.size(); ++i)
      numbers[i] = Interpolant::number(filled.scheme(), i, numbers[i]);
    return numbers;
  }

  void find_storage_bound(const std::vector<double>& numbers) {
    double off = 0.0;
    double relative = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (std::isnan(numbers[i])) continue;
      const double by = std::abs(values_[i] - numbers[i]);
      off = std::max(off, by);
      relative = std::max(relative, by / values_[i]);
      largest = std::max(largest, Interpolant::radius(scheme_, i, numbers[i]));
    }
    storage_bound_ = Interpolant::storage_bound(off, relative, largest);
  }

  S scheme_;
  CellMask rim_;
  Values values_;
  double storage_bound_ = 0.0;
};

/// Inverse depths in double: 8 bytes an entry, as the radii that they are made from.
template <PlaneExactScheme S>
using InverseDepthTable = StoredTable<S, MeshExact, std::vector<double>>;
/// Radii in float: 4 bytes an entry.
template <SamplingScheme S>
using FloatTable = StoredTable<S, Smooth, FloatValues>;
/// Radii in steps of 16 bits: 2 bytes an entry.
template <SamplingScheme S>
using Uint16Table = StoredTable<S, Smooth, Uint16Values>;
/// Inverse depths in float.
template <PlaneExactScheme S>
using FloatInverseDepthTable = StoredTable<S, MeshExact, FloatValues>;
/// Inverse depths in steps of 16 bits.
template <PlaneExactScheme S>
using Uint16InverseDepthTable = StoredTable<S, MeshExact, Uint16Values>;

}  // namespace impinge

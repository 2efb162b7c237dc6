// SPDX-License-Identifier: GPL-3.0-or-later
// The quantity y that a table interpolates, patch by patch, for table_bound.hpp: y = r for a RadialTable, y =
// 1 / (r depth) for an InverseDepthTable.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "sphere/radial_table.hpp"
#include "sphere/stored_table.hpp"

namespace impinge {

/// A tap without a surface is ignored if its weight is below this, as from rounding or the inset of a corner.
inline constexpr double kNegligibleWeight = 1e-6;

/// The interpolated value; NaN if a tap that counts has none.
inline double interpolated(const Stencil& stencil, std::span<const double> taps) {
  double sum = 0.0;
  double weights = 0.0;
  for (std::size_t k = 0; k < stencil.taps; ++k) {
    const double tap = taps[stencil.entry[k]];
    if (std::isnan(tap) && stencil.weight[k] < kNegligibleWeight) continue;
    if (stencil.weight[k] == 0.0) continue;
    sum += stencil.weight[k] * tap;
    weights += stencil.weight[k];
  }
  return sum / weights;
}

/// The least and the largest tap of a stencil; infinite, with least above largest, if none has a value.
inline void range_of_taps(const Stencil& stencil, std::span<const double> taps, double& least,
                          double& largest) {
  least = std::numeric_limits<double>::infinity();
  largest = -least;
  for (std::size_t k = 0; k < stencil.taps; ++k) {
    const double tap = taps[stencil.entry[k]];
    if (std::isnan(tap)) continue;
    least = std::min(least, tap);
    largest = std::max(largest, tap);
  }
}

/// Y = r of a RadialTable, on the patches of its scheme. Keeps references to both.
template <SamplingScheme S, class Patches>
class SmoothInterpolant {
 public:
  /// Whether patches run over the solid of the scheme; here over the unit sphere.
  static constexpr bool kFlat = false;
  /// The table and its scheme's patches_of().
  SmoothInterpolant(const RadialTable<S>& table, const Patches& patches) : table_(table), patches_(patches) {}

  const RadialTable<S>& table() const { return table_; }
  const Patches& patches() const { return patches_; }  // Y is bilinear on each of them

  /// The cell whose taps answer for x.
  std::size_t cell(const Vec3& x) const { return table_.scheme().stencil(x).cell; }
  /// Is there any answer in the cell of x?
  bool answers(const Vec3& x) const { return !table_.is_rim_cell(cell(x)); }
  /// Y at x; NaN if it has none.
  double value(const Vec3& x) const { return interpolated(table_.scheme().stencil(x), table_.radii()); }
  /// Least and largest tap of the stencil at x.
  void tap_range(const Vec3& x, double& least, double& largest) const {
    range_of_taps(table_.scheme().stencil(x), table_.radii(), least, largest);
  }

 private:
  const RadialTable<S>& table_;
  const Patches& patches_;
};

/// Y = 1 / (r depth) of an InverseDepthTable, on the flat patches of its scheme. Keeps references to both.
template <PlaneExactScheme S, class Patches>
class PlaneExactInterpolant {
 public:
  static constexpr bool kFlat = true;  // patches run over the solid
  /// The table and its scheme's flat_patches_of().
  PlaneExactInterpolant(const InverseDepthTable<S>& table, const Patches& patches)
      : table_(table), patches_(patches) {}

  const InverseDepthTable<S>& table() const { return table_; }
  const Patches& patches() const { return patches_; }  // Y is bilinear on each of them

  /// As in SmoothInterpolant.
  std::size_t cell(const Vec3& x) const { return table_.scheme().plane_stencil(x).cell; }
  /// As in SmoothInterpolant.
  bool answers(const Vec3& x) const { return !table_.rim_cells().contains(cell(x)); }
  /// Y at x; NaN if the table has no answer, as beside the curved border of a cell that a rim crosses.
  double value(const Vec3& x) const {
    if constexpr (!S::kFlatCells) {
      if (table_.rim_cells().contains(table_.scheme().stencil(x).cell)) return kNoSurface;
    }
    return interpolated(table_.scheme().plane_stencil(x), table_.values());
  }
  /// As in SmoothInterpolant.
  void tap_range(const Vec3& x, double& least, double& largest) const {
    range_of_taps(table_.scheme().plane_stencil(x), table_.values(), least, largest);
  }

 private:
  const InverseDepthTable<S>& table_;
  const Patches& patches_;
};

}  // namespace impinge

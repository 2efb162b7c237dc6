// SPDX-License-Identifier: GPL-3.0-or-later
// What a table interpolates, patch by patch, for table_bound.hpp: y = r for a RadialTable and y = 1 / (r
// depth) for an InverseDepthTable.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "sphere/inverse_depth_table.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {

// A tap without a surface is left out where its weight is that of rounding, or of the inset of a corner.
inline constexpr double kNegligibleWeight = 1e-6;

// Interpolated value, NaN where a tap that counts has none.
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

template <SamplingScheme S, class Patches>
class SmoothInterpolant {
 public:
  static constexpr bool kFlat = false;
  SmoothInterpolant(const RadialTable<S>& table, const Patches& patches) : table_(table), patches_(patches) {}

  const RadialTable<S>& table() const { return table_; }
  const Patches& patches() const { return patches_; }

  // Is there any answer in the cell of x?
  bool answers(const Vec3& x) const { return !table_.is_rim_cell(table_.scheme().stencil(x).cell); }
  double value(const Vec3& x) const { return interpolated(table_.scheme().stencil(x), table_.radii()); }
  void tap_range(const Vec3& x, double& least, double& largest) const {
    range_of_taps(table_.scheme().stencil(x), table_.radii(), least, largest);
  }

 private:
  const RadialTable<S>& table_;
  const Patches& patches_;
};

template <PlaneExactScheme S, class Patches>
class PlaneExactInterpolant {
 public:
  static constexpr bool kFlat = true;
  PlaneExactInterpolant(const InverseDepthTable<S>& table, const Patches& patches)
      : table_(table), patches_(patches) {}

  const InverseDepthTable<S>& table() const { return table_; }
  const Patches& patches() const { return patches_; }

  bool answers(const Vec3& x) const {
    return !table_.rim_cells().contains(table_.scheme().plane_stencil(x).cell);
  }
  // None beside the curved border of a cell that a rim crosses, where the table answers none.
  double value(const Vec3& x) const {
    if constexpr (!S::kFlatCells) {
      if (table_.rim_cells().contains(table_.scheme().stencil(x).cell)) return kNoSurface;
    }
    return interpolated(table_.scheme().plane_stencil(x), table_.inverse_depths());
  }
  void tap_range(const Vec3& x, double& least, double& largest) const {
    range_of_taps(table_.scheme().plane_stencil(x), table_.inverse_depths(), least, largest);
  }

 private:
  const InverseDepthTable<S>& table_;
  const Patches& patches_;
};

}  // namespace impinge

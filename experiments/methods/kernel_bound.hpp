// SPDX-License-Identifier: GPL-3.0-or-later
// Proven error of a kernel's answers beyond the bound of its table in exact arithmetic: from storing fewer
// bytes per number (sphere/stored_table.hpp) and from rounding (gap/simd/gap_kernels.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "table/packed_table.hpp"

namespace impinge::lab {

/// The largest radius of the surface, and the largest distance of a point from the centre, mm.
struct KernelReach {
  double radius = 0.0;
  double point = 0.0;
};

/// The greatest change within a cell, mm: D of gap_kernels.hpp, for radii up to `radius` mm.
template <SamplingScheme S, class Value>
double largest_step(const PackedTable<S, Value>& table, double radius) {
  if constexpr (std::same_as<S, Usid>) return radius;
  constexpr bool kCube = std::same_as<S, CubeGnomonic>;
  constexpr std::size_t kBits = 8 * sizeof(typename PackedTable<S, Value>::Word);
  const std::size_t row = table.stride;
  double largest = 0.0;
  for (std::size_t e = 0; e + row + 1 < table.values.size(); ++e) {
    if (e % row + 1 == row || (kCube && e / row % row + 1 == row)) continue;
    if (!table.none.empty() && (table.none[e / kBits] >> (e % kBits) & 1U) != 0) continue;
    const auto [least, most] =
        std::minmax({table.values[e], table.values[e + 1], table.values[e + row], table.values[e + row + 1]});
    const double low = table.smallest + table.step * static_cast<double>(least);
    const double high = table.smallest + table.step * static_cast<double>(most);
    largest = std::max(largest, kCube ? radius * (high / low - 1.0) : high - low);
  }
  return largest;
}

/// The error, mm, for a table with `cells` along a quarter turn (an edge of the cube).
template <SamplingScheme S, class Value>
double kernel_doubt(const PackedTable<S, Value>& table, double cells, const KernelReach& reach) {
  constexpr bool kCube = std::same_as<S, CubeGnomonic>;
  constexpr bool k16 = std::same_as<Value, std::uint16_t>;
  constexpr double kFloat = 0x1p-24;
  const double u = std::same_as<typename PackedTable<S, Value>::Real, float> ? kFloat : 0x1p-53;
  const double steps = kCube                   ? 13.0 * cells + 5.0
                       : std::same_as<S, Usid> ? 10.0 * cells + 52.0 * cells * cells
                                               : 28.0 * cells + 5.0;
  double doubt = u * (20.0 * (reach.radius + reach.point) + steps * largest_step(table, reach.radius));
  if constexpr (k16) {
    const double codes = std::numeric_limits<Value>::max();
    if (kCube) doubt += u * 5.0 * (1.0 + table.step * codes / table.smallest) * reach.radius;
    doubt += 0.5 * table.step * (kCube ? reach.radius / table.smallest : 1.0);
  } else if constexpr (std::same_as<Value, float>) {
    doubt += kFloat * reach.radius;
  }
  return doubt + 17.0 * 0x1p-53 * reach.radius;  // kSumRounding
}

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// Tables and points that the kernels are tested with.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <vector>

#include "gap/simd/packed_vertices.hpp"
#include "sphere/as_floats.hpp"
#include "support/directions.hpp"
#include "table/packed_table.hpp"

namespace impinge::test {

inline constexpr double kSmallest = 18.0;  // mm
inline constexpr double kLargest = 30.0;   // mm

// A bumpy body without surface round one direction, and a rim cell elsewhere.
template <SamplingScheme S>
RadialTable<S> bumpy_table(double precision_deg) {
  RadialTable<S> table(S::with_precision(precision_deg));
  for (std::size_t i = 0; i < table.scheme().size(); ++i) {
    const Vec3 u = table.scheme().direction(i);
    const double wave = std::sin(9.0 * u.x()) * std::cos(7.0 * u.y() + 1.0) * std::cos(5.0 * u.z());
    if (u.dot(Vec3(0.6, 0.0, 0.8)) < 0.97)
      table.radii()[i] = 0.5 * (kSmallest + kLargest) + 0.5 * (kLargest - kSmallest) * wave;
  }
  for (const Vec3& x : {Vec3(-0.3, 0.5, -0.7), Vec3(0.001, 0.002, 1.0), Vec3(1.0, -1e-4, 0.1)})
    table.mark_rim_cell(table.scheme().stencil(x).cell);
  return table;
}

// D of gap/simd/gap_kernels.hpp in one cell, where the table has this radius; 0 where the cell lacks a
// corner.
template <SamplingScheme S>
double step_in(const RadialTable<S>& table, const Stencil& cell, double radius) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (std::size_t k = 0; k < cell.taps; ++k) {
    const double r = table.radii()[cell.entry[k]];
    double number = r;
    if constexpr (std::same_as<S, CubeGnomonic>)
      number = 1.0 / (r * table.scheme().depth(table.scheme().direction(cell.entry[k])));
    if (std::isnan(r)) return 0.0;
    least = std::min(least, number);
    most = std::max(most, number);
  }
  return std::same_as<S, CubeGnomonic> ? radius * (most / least - 1.0) : most - least;
}

// Points that are floats, 5 to 40 mm away: random, at poles, seam and edges of the cube, and on entries.
template <SamplingScheme S>
std::vector<Vec3> float_points(const S& scheme) {
  std::vector<Vec3> directions = random_directions(20000, 47);
  for (const Vec3& u : special_directions()) directions.push_back(u);
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 0.0, 1.0})
      for (const double z : {-1.0, 0.0, 1.0})
        if (x != 0.0 || y != 0.0 || z != 0.0) directions.emplace_back(x, y, z);
  for (std::size_t i = 0; i < scheme.size(); i += 3) directions.push_back(scheme.direction(i));
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const double length = 5.0 + 35.0 * static_cast<double>(k % 101) / 100.0;
    directions[k] = as_floats(length * directions[k]);
  }
  return directions;
}

// The point and 26 round it, off by `share` of its length along each coordinate.
inline std::vector<Vec3> close_to(const Vec3& x, double share) {
  std::vector<Vec3> points;
  points.reserve(27);
  const double off = share * x.norm();
  for (const double a : {-off, 0.0, off})
    for (const double b : {-off, 0.0, off})
      for (const double c : {-off, 0.0, off}) points.emplace_back(x + Vec3(a, b, c));
  return points;
}

// m D at x: of the cells within `share` of its length, m those of a quarter turn.
template <SamplingScheme S>
double steps_at(const RadialTable<S>& table, const Vec3& x, double share, double radius) {
  double largest = 0.0;
  for (const Vec3& near : close_to(x, share))
    largest = std::max(largest, step_in(table, table.scheme().stencil(near), radius));
  return 0.25 * static_cast<double>(table.scheme().equator_points()) * largest;
}

}  // namespace impinge::test

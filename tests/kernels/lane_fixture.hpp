// SPDX-License-Identifier: GPL-3.0-or-later
// Tables and points that the kernels are tested with.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "kernels/lane_table.hpp"
#include "kernels/vertex_lanes.hpp"
#include "support/as_floats.hpp"
#include "support/directions.hpp"

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

}  // namespace impinge::test

// SPDX-License-Identifier: GPL-3.0-or-later
// Values on the nodes of a regular Cartesian grid about the centre, interpolated trilinearly.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "methods/benchmark_scene.hpp"
#include "sphere/radial_table.hpp"

namespace impinge::lab {

// A cube of nodes.
struct DistanceGridShape {
  double half_width = 0.0;  // mm, of the cube about the centre
  std::size_t nodes = 0;    // along each side, 2 or more
};

// Distance between neighbouring nodes, mm.
inline double spacing_of(const DistanceGridShape& shape) {
  return 2.0 * shape.half_width / static_cast<double>(shape.nodes - 1);
}

/// The cube that holds ball and socket in the scene's pose.
inline DistanceGridShape grid_shape(const BenchmarkScene& scene, std::size_t nodes) {
  double half_width = 0.0;
  for (const Vec3& v : scene.pair.socket.vertices)
    half_width = std::max(half_width, v.lpNorm<Eigen::Infinity>());
  for (const Vec3& v : scene.queries()) half_width = std::max(half_width, v.lpNorm<Eigen::Infinity>());
  return {half_width, nodes};
}

/// Proven bound on the error of a distance interpolated between nodes, mm. A distance changes by at most the
/// distance moved. So an answer, the mean of eight nodes x_i with weights w_i, errs by at most
///   sum w_i |x - x_i| <= sqrt(sum w_i |x - x_i|^2) = h sqrt(sum_k t_k (1 - t_k)) <= h sqrt(3) / 2,
/// where h is the spacing and t the place in the cell. Floats add 2^-23 of the largest distance, which is at
/// most the diagonal of the cube, since the surface is inside it.
inline double distance_grid_bound(const DistanceGridShape& shape) {
  const double largest = 2.0 * std::numbers::sqrt3 * shape.half_width;
  return 0.5 * std::numbers::sqrt3 * spacing_of(shape) + 0x1p-23 * largest;
}

class GridField {
 public:
  // values_of(nodes, out) writes the values of one row of nodes. Throws std::invalid_argument for fewer than
  // 2 nodes or no width.
  template <class ValuesOf>
  GridField(const DistanceGridShape& shape, ValuesOf&& values_of) : shape_(shape) {
    if (shape.nodes < 2 || !(shape.half_width > 0.0)) {
      throw std::invalid_argument("a distance grid needs two nodes or more a side, and a width above zero");
    }
    scale_ = 1.0 / spacing_of(shape);
    std::vector<Vec3> row(shape.nodes);
    std::vector<double> out(shape.nodes);
    values_.reserve(shape.nodes * shape.nodes * shape.nodes);
    for (std::size_t k = 0; k < shape.nodes; ++k) {
      for (std::size_t j = 0; j < shape.nodes; ++j) {
        for (std::size_t i = 0; i < shape.nodes; ++i)
          row[i] = Vec3(coordinate(i), coordinate(j), coordinate(k));
        values_of(row, out);
        for (const double value : out) values_.push_back(static_cast<float>(value));
      }
    }
  }

  // The interpolated value at x in the frame of the grid, mm; NaN outside the cube.
  double at(const Vec3& x) const {
    std::array<std::size_t, 3> low{};
    std::array<double, 3> t{};
    for (int axis = 0; axis < 3; ++axis) {
      if (!(std::abs(x[axis]) <= shape_.half_width)) return kNoSurface;
      const double place = (x[axis] + shape_.half_width) * scale_;
      const auto a = static_cast<std::size_t>(axis);
      low[a] = std::min(static_cast<std::size_t>(place), shape_.nodes - 2);
      t[a] = place - static_cast<double>(low[a]);
    }
    const auto along_x = [&](std::size_t j, std::size_t k) {
      const std::size_t at = (k * shape_.nodes + j) * shape_.nodes + low[0];
      return (1.0 - t[0]) * static_cast<double>(values_[at]) + t[0] * static_cast<double>(values_[at + 1]);
    };
    const auto along_y = [&](std::size_t k) {
      return (1.0 - t[1]) * along_x(low[1], k) + t[1] * along_x(low[1] + 1, k);
    };
    return (1.0 - t[2]) * along_y(low[2]) + t[2] * along_y(low[2] + 1);
  }

  std::size_t bytes() const { return values_.size() * sizeof(float); }  // memory of the values

 private:
  double coordinate(std::size_t i) const { return -shape_.half_width + static_cast<double>(i) / scale_; }

  DistanceGridShape shape_;
  double scale_ = 0.0;  // nodes a mm
  std::vector<float> values_;
};

}  // namespace impinge::lab

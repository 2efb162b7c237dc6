// SPDX-License-Identifier: GPL-3.0-or-later
#include "contenders/distance_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "contenders/cgal_distances.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {
namespace {

double spacing_of(const DistanceGridShape& shape) {
  return 2.0 * shape.half_width / static_cast<double>(shape.nodes - 1);
}

class DistanceGrid final : public RadiusMethod {
 public:
  DistanceGrid(const TriangleMesh& mesh, const DistanceGridShape& shape)
      : shape_(shape), scale_(1.0 / spacing_of(shape)), distances_(shape.nodes * shape.nodes * shape.nodes) {
    const auto closest = make_cgal_closest(mesh);
    std::vector<Vec3> row(shape.nodes);
    std::vector<double> distances(shape.nodes);
    auto next = distances_.begin();
    for (std::size_t k = 0; k < shape.nodes; ++k) {
      for (std::size_t j = 0; j < shape.nodes; ++j) {
        for (std::size_t i = 0; i < shape.nodes; ++i) row[i] = node(i, j, k);
        closest->answer(row, distances);
        next = std::ranges::transform(distances, next, [](double d) { return static_cast<float>(d); }).out;
      }
    }
  }

  void answer(std::span<const Vec3> points, std::span<double> out) override {
    for (std::size_t i = 0; i < points.size(); ++i) out[i] = distance(points[i]);
  }
  double bytes() const override { return static_cast<double>(distances_.size() * sizeof(float)); }

 private:
  double coordinate(std::size_t i) const { return -shape_.half_width + static_cast<double>(i) / scale_; }
  Vec3 node(std::size_t i, std::size_t j, std::size_t k) const {
    return {coordinate(i), coordinate(j), coordinate(k)};
  }

  double distance(const Vec3& x) const {
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
      return (1.0 - t[0]) * static_cast<double>(distances_[at]) +
             t[0] * static_cast<double>(distances_[at + 1]);
    };
    const auto along_y = [&](std::size_t k) {
      return (1.0 - t[1]) * along_x(low[1], k) + t[1] * along_x(low[1] + 1, k);
    };
    return (1.0 - t[2]) * along_y(low[2]) + t[2] * along_y(low[2] + 1);
  }

  DistanceGridShape shape_;
  double scale_;  // nodes a mm
  std::vector<float> distances_;
};

}  // namespace

DistanceGridShape grid_shape(const RaceScene& scene, std::size_t nodes) {
  double half_width = 0.0;
  for (const Vec3& v : scene.pair.socket.vertices)
    half_width = std::max(half_width, v.lpNorm<Eigen::Infinity>());
  for (const Vec3& v : scene.queries()) half_width = std::max(half_width, v.lpNorm<Eigen::Infinity>());
  return {half_width, nodes};
}

std::unique_ptr<RadiusMethod> make_distance_grid(const TriangleMesh& mesh, const DistanceGridShape& shape) {
  if (shape.nodes < 2 || !(shape.half_width > 0.0)) {
    throw std::invalid_argument("a distance grid needs two nodes or more a side, and a width above zero");
  }
  return std::make_unique<DistanceGrid>(mesh, shape);
}

double distance_grid_bound(const DistanceGridShape& shape) {
  // No point of the cube is farther from the surface, which is in it, than its diagonal.
  const double largest = 2.0 * std::numbers::sqrt3 * shape.half_width;
  return 0.5 * std::numbers::sqrt3 * spacing_of(shape) + 0x1p-23 * largest;
}

}  // namespace impinge

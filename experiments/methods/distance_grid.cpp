// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/distance_grid.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

#include "methods/cgal_distances.hpp"

namespace impinge::lab {
namespace {

class DistanceGrid final : public RadiusMethod {
 public:
  DistanceGrid(const TriangleMesh& mesh, const DistanceGridShape& shape)
      : distances_(shape, [closest = make_cgal_closest(mesh)](const std::vector<Vec3>& nodes,
                                                              std::vector<double>& out) {
          closest->answer(nodes, out);
        }) {}

  void answer(std::span<const Vec3> points, std::span<double> out) override {
    for (std::size_t i = 0; i < points.size(); ++i) out[i] = distances_.at(points[i]);
  }
  double bytes() const override { return static_cast<double>(distances_.bytes()); }

 private:
  GridField distances_;
};

}  // namespace

DistanceGridShape grid_shape(const BenchmarkScene& scene, std::size_t nodes) {
  double half_width = 0.0;
  for (const Vec3& v : scene.pair.socket.vertices)
    half_width = std::max(half_width, v.lpNorm<Eigen::Infinity>());
  for (const Vec3& v : scene.queries()) half_width = std::max(half_width, v.lpNorm<Eigen::Infinity>());
  return {half_width, nodes};
}

std::unique_ptr<RadiusMethod> make_distance_grid(const TriangleMesh& mesh, const DistanceGridShape& shape) {
  return std::make_unique<DistanceGrid>(mesh, shape);
}

double distance_grid_bound(const DistanceGridShape& shape) {
  // No point of the cube is farther from the surface, which is in it, than its diagonal.
  const double largest = 2.0 * std::numbers::sqrt3 * shape.half_width;
  return 0.5 * std::numbers::sqrt3 * spacing_of(shape) + 0x1p-23 * largest;
}

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// @can     points
// @links   gap method_cgal
//
// Method distance_grid: distances from the surface on the nodes of a regular Cartesian grid, by cgal_closest,
// in float, interpolated trilinearly. The thesis (Section 3.6.2) argues that its memory grows with the cube
// of the resolution, and that of a table with the square.

#include <memory>

#include "methods/cgal.hpp"
#include "methods/grid_field.hpp"

namespace impinge::lab {
namespace {

PointQuery make_grid(const TriangleMesh& mesh, const DistanceGridShape& shape) {
  const auto field = std::make_shared<const GridField>(
      shape, [closest = make_cgal_closest(mesh)](const std::vector<Vec3>& nodes, std::vector<double>& out) {
        closest.answer(nodes, out);
      });
  return one_by_one([field](const Vec3& x) { return field->at(x); }, static_cast<double>(field->bytes()));
}

}  // namespace

Method distance_grid_method() {
  Method method{.name = "distance_grid", .label = "Cartesian distance grid"};
  method.lacks = "points outside of its cube";
  method.points = [](const BenchmarkScene& scene, const PointSizes& sizes) {
    std::vector<PointCase> cases;
    for (const std::size_t nodes : sizes.grid_nodes) {
      const DistanceGridShape shape = grid_shape(scene, nodes);
      PointCase one;
      one.setting = "grid " + std::to_string(nodes);
      one.place = 15;
      one.kind = "grid";
      one.storage = "float";
      one.measure = Measure::euclidean;
      one.make = [&mesh = scene.surface(), shape] { return make_grid(mesh, shape); };
      one.bound = [shape](const PointQuery&) { return MethodBound{distance_grid_bound(shape)}; };
      cases.push_back(std::move(one));
    }
    return cases;
  };
  return method;
}

}  // namespace impinge::lab

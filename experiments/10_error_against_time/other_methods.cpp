// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <utility>

#include "10_error_against_time/methods.hpp"
#include "methods/cgal_distances.hpp"
#include "methods/distance_grid.hpp"
#include "methods/embree_closest.hpp"
#include "methods/embree_rays.hpp"
#include "methods/fcl_pose.hpp"
#include "methods/pairwise_rays.hpp"

namespace impinge::lab {
namespace {

MethodMaker maker_of(std::string name, std::string setting, Measure measure,
                     std::function<std::unique_ptr<RadiusMethod>()> make) {
  MethodMaker maker;
  maker.name = std::move(name);
  maker.setting = std::move(setting);
  maker.kind = "library";
  maker.measure = measure;
  maker.make = std::move(make);
  return maker;
}

MethodMaker grid_maker(const BenchmarkScene& scene, std::size_t nodes) {
  const DistanceGridShape shape = grid_shape(scene, nodes);
  MethodMaker maker = maker_of("distance_grid", "grid " + std::to_string(nodes), Measure::euclidean,
                               [&mesh = scene.surface(), shape] { return make_distance_grid(mesh, shape); });
  maker.kind = "grid";
  maker.storage = "float";
  maker.bound = [shape](const RadiusMethod& /*method*/) {
    MethodBound bound;
    bound.bound_mm = distance_grid_bound(shape);
    return bound;
  };
  return maker;
}

}  // namespace

std::vector<MethodMaker> other_methods(const BenchmarkScene& scene,
                                       const std::vector<std::size_t>& grid_nodes) {
  const TriangleMesh& mesh = scene.surface();
  std::vector<MethodMaker> makers;
  for (const auto& [quality, setting] :
       {std::pair{EmbreeQuality::fast, "fast"}, {EmbreeQuality::robust, "robust"}}) {
    for (const int width : {1, 8, 16}) {
      makers.push_back(maker_of("embree_ray" + std::to_string(width), setting, Measure::radial,
                                [&mesh, width, quality = quality] {
                                  return make_embree_rays(mesh, {width, quality});
                                }));
    }
  }
  makers.push_back(maker_of("embree_closest", "robust", Measure::euclidean,
                            [&mesh] { return make_embree_closest(mesh); }));
  makers.push_back(
      maker_of("cgal_first_hit", "", Measure::radial, [&mesh] { return make_cgal_first_hit(mesh); }));
  makers.push_back(
      maker_of("cgal_closest", "", Measure::euclidean, [&mesh] { return make_cgal_closest(mesh); }));
  makers.push_back(maker_of("fcl_collide", "", Measure::pose, [&scene] { return make_fcl_collide(scene); }));
  makers.push_back(
      maker_of("fcl_distance", "", Measure::pose, [&scene] { return make_fcl_distance(scene); }));
  makers.push_back(maker_of("pairwise", "", Measure::radial,
                            [&mesh] { return make_pairwise_rays(mesh, BenchmarkScene::kLayer); }));
  makers.back().kind = "brute";
  for (const std::size_t nodes : grid_nodes) makers.push_back(grid_maker(scene, nodes));
  return makers;
}

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "18_baselines/baseline_methods.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <benchmark/benchmark.h>

#include "files/csv.hpp"
#include "methods/cartesian_field.hpp"
#include "methods/detection_benchmark.hpp"
#include "methods/distance_grid.hpp"
#include "methods/hu_voxels.hpp"
#include "methods/maciel_triangles.hpp"
#include "methods/table_check.hpp"
#include "reference/closest_point.hpp"
#include "sphere/entries_inside.hpp"
#include "sphere/schemes/rsid.hpp"

namespace impinge::lab {
namespace {

constexpr double kRounding = 1e-9;  // mm, of a radius in double

[[noreturn]] void broken(const std::string& method, const std::string& what) {
  throw std::runtime_error(method + ": " + what + ": its results mean nothing until that is resolved");
}

BaselineMethod voxels(const BallSocketPair& joint, double size) {
  auto touch = std::make_unique<HuVoxels>(joint.ball, joint.socket, size);
  Pose deep;  // somewhere, so that there are hits
  deep.translation = Vec3(0.0, 0.0, 5.0);
  const auto hits = some_of(touch->collided(deep), 50);
  const auto apart = closest_distances(joint.socket, {hits});
  if (std::ranges::any_of(apart, [size](double d) { return d > std::numbers::sqrt3 * size; }))
    broken("hu_voxels", "a collided point is farther from the socket than the voxel is wide");
  BaselineMethod method;
  method.name = touch->name();
  method.setting = Cell(size).text() + " mm";
  method.size = size;
  method.bytes = static_cast<double>(touch->bytes());
  method.touch = std::move(touch);
  method.build = [&joint, size] { benchmark::DoNotOptimize(HuVoxels(joint.ball, joint.socket, size)); };
  return method;
}

BaselineMethod triangles(const BallSocketPair& joint, std::size_t side, const BaselinePoints& points,
                         double most_pairs) {
  TriangleTable table = fill_triangles(joint.ball, side, Layer::farthest);
  std::vector<double> radius;
  radius.reserve(points.on_socket.size());
  for (std::size_t i = 0; i < points.on_socket.size(); ++i) {
    radius.push_back(radius_at(table, joint.ball, points.on_socket[i]));
    if (radius.back() > points.radius[i] + kRounding)
      broken("maciel_triangles", "a triangle is farther than the farthest");
  }
  BaselineMethod method;
  method.name = "maciel_triangles";
  method.setting = std::to_string(side) + " x " + std::to_string(side);
  method.size = static_cast<double>(side);
  method.answers = judge_answers(radius, points.radius);
  method.missed_faces = static_cast<double>(missed_faces(table, joint.ball));
  method.work = static_cast<double>(side * side) * static_cast<double>(joint.ball.faces.size());
  if (method.work <= most_pairs) {
    method.build = [&joint, side] {
      benchmark::DoNotOptimize(fill_triangles_pairwise(joint.ball, side, Layer::farthest));
    };
  }
  auto touch = std::make_unique<MacielTriangles>(joint.ball, joint.socket, std::move(table));
  method.bytes = static_cast<double>(touch->bytes());
  method.touch = std::move(touch);
  return method;
}

BaselineMethod field(const BallSocketPair& joint, std::size_t nodes, const BaselinePoints& points) {
  const DistanceGridShape shape = grid_shape({"", joint, {}}, nodes);
  const GridField grid = make_signed_field(joint.socket, shape);
  const double bound = distance_grid_bound(shape);
  std::vector<double> distance;
  distance.reserve(points.on_ball.size());
  for (const Vec3& x : points.on_ball) {
    distance.push_back(std::abs(grid.at(x)));
    if (distance.back() > points.distance[distance.size() - 1] + bound)
      broken("cartesian_field", "a distance exceeds the exact one by more than its bound");
  }
  BaselineMethod method;
  method.name = "cartesian_field";
  method.setting = std::to_string(nodes) + " nodes a side";
  method.size = static_cast<double>(nodes);
  method.answers = judge_answers(distance, points.distance);
  method.bytes = static_cast<double>(grid.bytes());
  method.touch = std::make_unique<CartesianField>(joint.ball, grid);
  method.build = [&joint, shape] { benchmark::DoNotOptimize(make_signed_field(joint.socket, shape)); };
  return method;
}

// Faces without an entry inside.
std::size_t faces_without_entry(const TriangleMesh& mesh, const Rsid& scheme) {
  const auto walker = scheme.walker();
  std::size_t without = 0;
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    if (cone.edge_on()) continue;
    bool met = false;
    for_each_entry_inside(walker, cone, [&met](std::size_t, const Vec3&) { met = true; });
    without += met ? 0U : 1U;
  }
  return without;
}

BaselineMethod table(const BallSocketPair& joint, double precision, const BaselinePoints& points) {
  const auto tables = make_tables<Rsid>(joint, precision);
  TableCheck check;
  check.entries = 300;
  check.tolerance = kRounding;
  require_radii(tables->ball, joint.ball, Layer::farthest, check);
  std::vector<double> radius;
  radius.reserve(points.on_socket.size());
  for (const Vec3& y : points.on_socket) radius.push_back(tables->ball.radius_at(y));
  BaselineMethod method;
  method.name = "rsid";
  method.setting = Cell(precision).text() + " degrees";
  method.size = precision;
  method.answers = judge_answers(radius, points.radius);
  const std::size_t rims = tables->ball.rim_cells().bytes() + tables->socket.rim_cells().bytes();
  method.bytes = static_cast<double>(2 * RadialTable<Rsid>::bytes(tables->ball.scheme()) + rims);
  method.missed_faces = static_cast<double>(faces_without_entry(joint.ball, tables->ball.scheme()));
  method.touch = std::make_unique<TableScan<Rsid>>(joint.ball, joint.socket, tables);
  method.build = [&joint, precision] { benchmark::DoNotOptimize(make_tables<Rsid>(joint, precision)); };
  return method;
}

}  // namespace

std::vector<BaselineMethod> baseline_methods(const BallSocketPair& joint, const BaselineSizes& sizes,
                                             const BaselinePoints& points) {
  std::vector<BaselineMethod> all;
  for (const double size : sizes.voxels_mm) all.push_back(voxels(joint, size));
  for (const std::size_t side : sizes.rays) all.push_back(triangles(joint, side, points, sizes.most_pairs));
  for (const std::size_t nodes : sizes.nodes) all.push_back(field(joint, nodes, points));
  for (const double precision : sizes.precisions_deg) all.push_back(table(joint, precision, points));
  return all;
}

}  // namespace impinge::lab

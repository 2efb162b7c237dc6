// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_error_against_time/probes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include <Eigen/Geometry>

#include "mesh/jump_edges.hpp"
#include "mesh/triangle_distance.hpp"
#include "reference/closest_point.hpp"
#include "reference/exact_radius.hpp"
#include "table/pairwise.hpp"
#include "table/probe_directions.hpp"

namespace impinge::lab {
namespace {

constexpr double kPolarCap = 3.0 * kDegree;
constexpr double kBeside = 1e-7;  // radians, from seam and rim

void append_evenly(std::vector<Vec3>& list, const std::vector<Vec3>& more, std::size_t most) {
  const std::size_t count = std::min(most, more.size());
  for (std::size_t k = 0; k < count; ++k) list.push_back(more[k * more.size() / count]);
}

// On the half-plane theta = 0 and a little to both of its sides.
std::vector<Vec3> seam_directions(std::size_t count) {
  std::vector<Vec3> directions;
  for (std::size_t k = 0; k < count; ++k) {
    const double phi = kPi * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    const double beside = kBeside * (static_cast<double>(k % 3) - 1.0);
    directions.push_back(Vec3(std::sin(phi), beside, std::cos(phi)).normalized());
  }
  return directions;
}

// Through points of the rim, a little to both of its sides, and a good way to both.
std::vector<Vec3> rim_directions(const TriangleMesh& mesh) {
  std::vector<Vec3> directions;
  for (const JumpEdge& edge : jump_edges(mesh)) {
    const Vec3& from = mesh.vertices[edge.from];
    const Vec3& to = mesh.vertices[edge.to];
    const Vec3 across = from.cross(to);
    if (across.squaredNorm() == 0.0) continue;
    for (const double aside : {-1e-3, -kBeside, 0.0, kBeside, 1e-3})
      directions.push_back(((0.6 * from + 0.4 * to).normalized() + aside * across.normalized()).normalized());
  }
  return directions;
}

// Centroids of the faces with the largest tan psi.
std::vector<Vec3> grazing_directions(const TriangleMesh& mesh, std::size_t most) {
  std::vector<std::pair<double, Vec3>> faces;
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    const auto& [a, b, c] = cone.corners();
    if (!cone.edge_on()) faces.emplace_back(-cone.largest_slope(), (a + b + c).normalized());
  }
  std::ranges::stable_sort(faces, {}, [](const auto& face) { return face.first; });
  faces.resize(std::min(most, faces.size()));
  std::vector<Vec3> directions(faces.size());
  std::ranges::transform(faces, directions.begin(), [](const auto& face) { return face.second; });
  return directions;
}

double mean_radius(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Vec3& v : mesh.vertices) sum += v.norm();
  return sum / static_cast<double>(mesh.vertices.size());
}

double least_distance(const TriangleMesh& mesh, const Vec3& x) {
  double squared = std::numeric_limits<double>::infinity();
  for (const Face& face : mesh.faces) {
    squared = std::min(squared, squared_distance_to_triangle(x, corner(mesh, face, 0), corner(mesh, face, 1),
                                                             corner(mesh, face, 2)));
  }
  return std::sqrt(squared);
}

BenchmarkProbes directions_of(const TriangleMesh& mesh, const ProbeOptions& options) {
  BenchmarkProbes probes;
  probes.points = uniform_directions(options.uniform, options.seed);
  probes.uniform = options.uniform;
  const auto features = stratified_directions(mesh, options.each_feature);
  probes.points.insert(probes.points.end(), features.begin(), features.end());
  return probes;
}

}  // namespace

std::vector<Vec3> stratified_directions(const TriangleMesh& mesh, std::size_t each) {
  const std::vector<Vec3> features = feature_directions(mesh);
  const auto edges = features.begin() + static_cast<std::ptrdiff_t>(mesh.vertices.size());
  std::vector<Vec3> directions;
  append_evenly(directions, {features.begin(), edges}, each);
  append_evenly(directions, {edges, features.end()}, each);
  append_evenly(directions, polar_directions(kPolarCap, each), each);
  append_evenly(directions, seam_directions(each), each);
  append_evenly(directions, rim_directions(mesh), each);
  append_evenly(directions, grazing_directions(mesh, each), each);
  return directions;
}

BenchmarkProbes radial_probes(const TriangleMesh& mesh, Layer layer, const ProbeOptions& options) {
  BenchmarkProbes probes = directions_of(mesh, options);
  probes.in_float = options.float_at > 0.0;
  if (probes.in_float)
    for (Vec3& x : probes.points) x = probes.place(options.float_at * x);
  const auto caster = std::make_shared<const RayCaster>(mesh);
  probes.truth_at = [caster, layer](const Vec3& x) { return caster->cast(x.normalized(), layer); };
  probes.truth = exact_radii(mesh, {probes.points, layer, {}});
  return probes;
}

BenchmarkProbes radial_probes(const BenchmarkScene& scene, const ProbeOptions& options) {
  return radial_probes(scene.surface(), BenchmarkScene::kLayer, options);
}

BenchmarkProbes euclidean_probes(const TriangleMesh& mesh, double radius, const ProbeOptions& options) {
  BenchmarkProbes probes = directions_of(mesh, options);
  for (Vec3& x : probes.points) x *= radius;
  probes.truth_at = [&mesh](const Vec3& x) { return least_distance(mesh, x); };
  probes.truth = closest_distances(mesh, {probes.points, {}});
  return probes;
}

BenchmarkProbes euclidean_probes(const BenchmarkScene& scene, const ProbeOptions& options) {
  return euclidean_probes(scene.surface(), mean_radius(scene.pair.ball), options);
}

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_error_against_time/errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "harness/statistics.hpp"
#include "mesh/jump_edges.hpp"
#include "mesh/triangle_distance.hpp"
#include "reference/closest_point.hpp"
#include "reference/exact_radius.hpp"
#include "table/pairwise.hpp"
#include "table/probe_directions.hpp"

namespace impinge::lab {
namespace {

double error_at(const PointQuery& query, const BenchmarkProbes& probes, const Vec3& x) {
  double answer = 0.0;
  query.answer(std::span(&x, 1), std::span(&answer, 1));
  return answer - probes.truth_at(x);
}

void take(BenchmarkErrors& errors, double error, const Vec3& x) {
  if (std::isnan(error)) return;
  if (std::abs(error) > errors.max()) errors.worst = x;
  errors.max_over = std::max(errors.max_over, error);
  errors.max_under = std::max(errors.max_under, -error);
}

// The largest |error| that ascent reaches from a start, at the start's distance from the centre.
double climb(const PointQuery& query, const BenchmarkProbes& probes, const AscentOptions& ascent, Vec3 x,
             BenchmarkErrors& errors) {
  double best = std::abs(error_at(query, probes, x));
  double step = ascent.first_step;
  std::size_t asked = 0;
  while (asked < ascent.steps) {
    const Vec3 across = x.unitOrthogonal();
    const Vec3 along = x.normalized().cross(across);
    bool better = false;
    for (const auto& [a, b] : {std::pair{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}}) {
      const Vec3 next =
          probes.place(x.norm() * (x.normalized() + step * (a * across + b * along)).normalized());
      const double error = error_at(query, probes, next);
      ++asked;
      take(errors, error, next);
      if (!(std::abs(error) > best)) continue;
      best = std::abs(error);
      x = next;
      better = true;
      break;
    }
    if (!better) step *= 0.5;
  }
  errors.directions += asked;
  return best;
}

// Indices of the probes with the largest errors, the worst first.
std::vector<std::size_t> worst_places(const std::vector<double>& error, std::size_t count) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < error.size(); ++k) {
    if (!std::isnan(error[k])) places.push_back(k);
  }
  count = std::min(count, places.size());
  const auto middle = places.begin() + static_cast<std::ptrdiff_t>(count);
  std::ranges::partial_sort(places, middle, [&](std::size_t i, std::size_t j) {
    return std::pair(-std::abs(error[i]), i) < std::pair(-std::abs(error[j]), j);
  });
  places.resize(count);
  return places;
}

void summarise_uniform(BenchmarkErrors& errors, std::span<const double> error) {
  std::vector<double> sizes;
  double squares = 0.0;
  for (const double e : error) {
    if (std::isnan(e)) continue;
    sizes.push_back(std::abs(e));
    squares += e * e;
  }
  if (sizes.empty()) return;
  errors.rms = std::sqrt(squares / static_cast<double>(sizes.size()));
  errors.p99 = quantile(sizes, 0.99);
  errors.uniform_max = std::ranges::max(sizes);
}

constexpr double kPolarCap = 3.0 * kDegree;
constexpr double kBeside = 1e-7;  // radians, from seam and rim

void append_evenly(std::vector<Vec3>& list, const std::vector<Vec3>& more, std::size_t most) {
  const std::size_t count = std::min(most, more.size());
  for (std::size_t k = 0; k < count; ++k) list.push_back(more[k * more.size() / count]);
}

// On the half-plane theta = 0, and a little to both sides of it.
std::vector<Vec3> seam_directions(std::size_t count) {
  std::vector<Vec3> directions;
  for (std::size_t k = 0; k < count; ++k) {
    const double phi = kPi * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    const double beside = kBeside * (static_cast<double>(k % 3) - 1.0);
    directions.push_back(Vec3(std::sin(phi), beside, std::cos(phi)).normalized());
  }
  return directions;
}

// Through points of the rim, and on both sides of it, a little and a good way off.
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

// About so many points are compared with both truths.
constexpr std::size_t kComparedTruths = 1000;

void compare_truths(BenchmarkProbes& probes) {
  for (std::size_t k = 0; k < probes.points.size(); k += probes.points.size() / kComparedTruths + 1) {
    const double apart = std::abs(probes.truth_at(probes.points[k]) - probes.truth[k]);
    if (apart > probes.truth_apart) probes.truth_apart = apart;  // a NaN is not larger
  }
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

BenchmarkErrors measure_errors(const PointQuery& query, const BenchmarkProbes& probes,
                               const AscentOptions& ascent) {
  BenchmarkErrors errors;
  errors.directions = probes.points.size();
  std::vector<double> error(probes.points.size());
  query.answer(probes.points, error);
  for (std::size_t k = 0; k < error.size(); ++k) {
    const bool answered = !std::isnan(error[k]);
    const bool there = !std::isnan(probes.truth[k]);
    errors.misses += there && !answered ? 1 : 0;
    errors.false_hits += answered && !there ? 1 : 0;
    error[k] -= probes.truth[k];
    take(errors, error[k], probes.points[k]);
    if (k >= probes.uniform && !std::isnan(error[k]))
      errors.feature_max = std::max(errors.feature_max, std::abs(error[k]));
  }
  summarise_uniform(errors, std::span(error).first(probes.uniform));
  for (const std::size_t place : worst_places(error, ascent.starts)) {
    const double found = climb(query, probes, ascent, probes.points[place], errors);
    errors.adversarial_max = std::max(errors.adversarial_max, found);
  }
  return errors;
}

std::string Violation::text() const {
  const auto hex = [](double x) {
    std::array<char, 40> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%a", x);
    return std::string(buffer.data());
  };
  const nlohmann::json line{{"scene", scene},
                            {"method", method},
                            {"setting", setting},
                            {"error_um", 1000.0 * error_mm},
                            {"bound_um", 1000.0 * bound_mm},
                            {"point_mm", {hex(point.x()), hex(point.y()), hex(point.z())}}};
  return line.dump();
}

std::optional<Violation> find_violation(const BenchmarkErrors& errors, const MethodBound& bound) {
  const double largest = errors.max();
  if (!(largest > bound.bound_mm + kBenchmarkRounding)) return std::nullopt;  // a NaN promises nothing
  Violation violation;
  violation.error_mm = largest;
  violation.bound_mm = bound.bound_mm;
  violation.point = errors.worst;
  return violation;
}

BoundViolated::BoundViolated(const Violation& violation)
    : std::runtime_error("a proven bound does not hold, so the proof or the program is wrong: " +
                         violation.text()),
      violation_(violation) {}

void require_bound(const BenchmarkErrors& errors, const MethodBound& bound, const CaseName& name) {
  auto violation = find_violation(errors, bound);
  if (!violation) return;
  violation->scene = name.scene;
  violation->method = name.method;
  violation->setting = name.setting;
  throw BoundViolated(*violation);
}

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
  compare_truths(probes);
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
  compare_truths(probes);
  return probes;
}

BenchmarkProbes euclidean_probes(const BenchmarkScene& scene, const ProbeOptions& options) {
  return euclidean_probes(scene.surface(), mean_radius(scene.pair.ball), options);
}

}  // namespace impinge::lab

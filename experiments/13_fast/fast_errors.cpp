// SPDX-License-Identifier: GPL-3.0-or-later
#include "13_fast/fast_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mesh/triangle_distance.hpp"
#include "table/pairwise.hpp"
#include "table/probe_directions.hpp"

namespace impinge::lab {
namespace {

constexpr double kDistance = 25.0;           // mm, of the points
constexpr double kMostError = 1.0;           // mm, of the coarsest table here
constexpr double kMostFalseHits = 0.01;      // of the points: those on the rim itself, in float
constexpr std::size_t kEuclideanShare = 16;  // a distance takes so many times as long as a ray
constexpr const char* kCure = ": its time means nothing until its answers are right";

void require_good(const FastErrors& errors, const GapCase& method) {
  const double false_share = static_cast<double>(errors.false_hits) / static_cast<double>(errors.probes);
  if (errors.largest_mm > kMostError || false_share > kMostFalseHits) {
    throw std::runtime_error(method.name + " " + method.setting + " " + method.storage + " is off by " +
                             std::to_string(errors.largest_mm) + " mm, with " +
                             std::to_string(errors.false_hits) + " false hits" + kCure);
  }
}

// From all triangles.
double distance_of(const TriangleMesh& mesh, const Vec3& x) {
  double squared = std::numeric_limits<double>::infinity();
  for (const Face& face : mesh.faces)
    squared = std::min(squared, squared_distance_to_triangle(x, corner(mesh, face, 0), corner(mesh, face, 1),
                                                             corner(mesh, face, 2)));
  return std::sqrt(squared);
}

FastErrors distance_errors(const GapQuery& query, const FastProbes& probes) {
  FastErrors errors;
  GapScratch scratch;
  query.scan(probes.asked, {}, scratch);
  errors.probes = probes.distances.size();
  for (std::size_t k = 0; k < probes.distances.size(); ++k) {
    const double distance = scratch.gap(k * kEuclideanShare);
    if (std::isnan(distance)) {
      ++errors.misses;
      continue;
    }
    errors.largest_mm = std::max(errors.largest_mm, std::abs(distance - probes.distances[k]));
  }
  return errors;
}

}  // namespace

FastProbes fast_probes(const AskedSurface& surface, std::size_t count, std::uint64_t seed) {
  std::vector<Vec3> points = uniform_directions(count / 2, seed);
  const std::vector<Vec3> features = feature_directions(surface.mesh);
  const std::size_t taken = std::min(count / 2, features.size());
  for (std::size_t k = 0; k < taken; ++k) points.push_back(features[k * features.size() / taken]);
  const RayCaster caster(surface.mesh);
  std::vector<double> truth;
  for (Vec3& x : points) {
    truth.push_back(signed_gap(surface.scanned, caster.cast(x, surface.layer), kDistance));
    x *= kDistance;
  }
  std::vector<double> distances;
  for (std::size_t k = 0; k < points.size() / kEuclideanShare; ++k)
    distances.push_back(distance_of(surface.mesh, points[k * kEuclideanShare]));
  return {AskedPoints(std::move(points)), std::move(truth), std::move(distances)};
}

FastErrors fast_errors(const GapQuery& query, const FastProbes& probes, const GapCase& method) {
  FastErrors errors;
  if (!query.answers) return {kNoSurface};
  if (query.measure == Measure::euclidean) {
    errors = distance_errors(query, probes);
    require_good(errors, method);
    return errors;
  }
  GapScratch scratch;
  query.scan(probes.asked, {}, scratch);
  errors.probes = probes.truth.size();
  errors.undecided = scratch.certified.undecided.size();
  for (std::size_t i = 0; i < probes.truth.size(); ++i) {
    const double gap = scratch.gap(i);
    const double exact = probes.truth[i];
    if (std::isnan(gap) != std::isnan(exact)) ++(std::isnan(gap) ? errors.misses : errors.false_hits);
    if (std::isnan(gap) || std::isnan(exact)) continue;
    errors.largest_mm = std::max(errors.largest_mm, std::abs(gap - exact));
  }
  require_good(errors, method);
  return errors;
}

}  // namespace impinge::lab

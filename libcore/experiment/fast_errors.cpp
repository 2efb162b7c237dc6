// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/fast_errors.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sampling/pairwise.hpp"
#include "sampling/probe_directions.hpp"

namespace impinge {
namespace {

constexpr double kDistance = 25.0;       // mm, of the points
constexpr double kMostError = 1.0;       // mm, of the coarsest table here
constexpr double kMostFalseHits = 0.01;  // of the points: those on the rim itself, in float
constexpr const char* kCure = ": its time means nothing until its answers are right";

}  // namespace

FastProbes fast_probes(const AskedSurface& surface, std::size_t count, std::uint64_t seed) {
  std::vector<Vec3> points = uniform_directions(count / 2, seed);
  const std::vector<Vec3> features = feature_directions(surface.mesh);
  const std::size_t taken = std::min(count / 2, features.size());
  for (std::size_t k = 0; k < taken; ++k) points.push_back(features[k * features.size() / taken]);
  const RayCaster caster(surface.mesh);
  const double sign = surface.scan == Scan::ball ? 1.0 : -1.0;
  std::vector<double> truth;
  for (Vec3& x : points) {
    truth.push_back(sign * (caster.cast(x, surface.layer) - kDistance));
    x *= kDistance;
  }
  return {AskedPoints(std::move(points)), std::move(truth)};
}

FastErrors fast_errors(GapMethod& method, const FastProbes& probes, const GapMethodMaker& maker) {
  FastErrors errors;
  if (!method.answers()) return {kNoSurface};
  GapMethod::Scratch scratch;
  method.scan(probes.asked, {}, scratch);
  errors.probes = probes.truth.size();
  errors.undecided = method.undecided(scratch);
  for (std::size_t i = 0; i < probes.truth.size(); ++i) {
    const double gap = method.gap(scratch, i);
    const double exact = probes.truth[i];
    if (std::isnan(gap) != std::isnan(exact)) ++(std::isnan(gap) ? errors.misses : errors.false_hits);
    if (std::isnan(gap) || std::isnan(exact)) continue;
    errors.largest_mm = std::max(errors.largest_mm, std::abs(gap - exact));
  }
  const double false_share = static_cast<double>(errors.false_hits) / static_cast<double>(errors.probes);
  if (errors.largest_mm > kMostError || false_share > kMostFalseHits) {
    throw std::runtime_error(maker.name + " " + maker.setting + " " + maker.storage + " is off by " +
                             std::to_string(errors.largest_mm) + " mm, with " +
                             std::to_string(errors.false_hits) + " false hits" + kCure);
  }
  return errors;
}

}  // namespace impinge

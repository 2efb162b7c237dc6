// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/proof_json.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/json_values.hpp"

namespace impinge {
namespace {

using nlohmann::json;

json vertex_verdicts_json(const VertexVerdicts& verdicts) {
  return {{"impinged", verdicts.impinged},
          {"clear_by_bound", verdicts.by_bound.clear},
          {"impinged_by_bound", verdicts.by_bound.impinged},
          {"undecided_by_bound", verdicts.by_bound.undecided},
          {"without_gap", verdicts.without_gap},
          {"bounds_refuted", verdicts.refuted}};
}

}  // namespace

const char* verdict_name(bool impinged) { return impinged ? "impinged" : "clear"; }

nlohmann::json bounds_json(const std::optional<PoseVerdicts>& proven) {
  if (!proven) return nullptr;
  return {{"largest", proven->largest_mm},
          {"vertices_without_bound", proven->unbounded},
          {"smallest_gap_between", interval_json(proven->smallest.low, proven->smallest.high)},
          {"vertices_measured_on_the_faces", proven->smallest.measured}};
}

nlohmann::json distances_json(const PoseAnswer& found) {
  if (found.ball.distance.empty()) return nullptr;
  constexpr double kOverstated = 1.1;
  double low = std::numeric_limits<double>::infinity();
  double high = low;
  double largest = 1.0;
  std::size_t overstated = 0;
  for (const SurfaceAnswer* v : {&found.ball, &found.socket}) {
    for (std::size_t i = 0; i < v->gap.size(); ++i) {
      const DistanceBracket& distance = v->distance[i];
      low = std::min(low, distance.lower_mm);
      high = std::min(high, distance.upper_mm);
      const double bound = v->bound.empty() ? 0.0 : v->bound[i];
      const double ratio = (std::abs(v->gap[i]) - bound) / distance.upper_mm;
      if (std::isnan(ratio)) continue;
      largest = std::max(largest, ratio);
      if (ratio > kOverstated) ++overstated;
    }
  }
  return {{"smallest_between", interval_json(low, high)},
          {"gaps_above_it_by_a_tenth", overstated},
          {"largest_gap_over_it", largest}};
}

nlohmann::json certificate_json(const std::optional<Certificate>& found) {
  if (!found) return nullptr;
  const Certificate& certificate = *found;
  const auto& deepest = certificate.deepest;
  return {{"surfaces", verdict_name(certificate.surfaces_impinged)},
          {"vertices", verdict_name(certificate.vertices_impinged())},
          {"ball", vertex_verdicts_json(certificate.ball)},
          {"socket", vertex_verdicts_json(certificate.socket)},
          {"deepest_mm", deepest ? nlohmann::json(deepest->depth) : nlohmann::json(nullptr)},
          {"deepest_at", deepest ? nlohmann::json(word_of(deepest->kind)) : nlohmann::json(nullptr)}};
}

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/proof_json.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/json_values.hpp"

namespace impinge {
namespace {

using nlohmann::json;

const char* name(OverlayKind kind) {
  switch (kind) {
    case OverlayKind::ball_corner:
      return "ball vertex";
    case OverlayKind::socket_corner:
      return "socket vertex";
    case OverlayKind::centre:
      return "centre of the ball";
    case OverlayKind::crossing:
      break;
  }
  return "crossing of edges";
}

json vertex_verdicts_json(const VertexVerdicts& verdicts) {
  return {{"impinged", verdicts.impinged},
          {"clear_by_bound", verdicts.by_bound.clear},
          {"impinged_by_bound", verdicts.by_bound.impinged},
          {"undecided_by_bound", verdicts.by_bound.undecided},
          {"without_gap", verdicts.without_gap},
          {"bounds_refuted", verdicts.refuted}};
}

}  // namespace

nlohmann::json bounds_json(const ReportedSurface& ball, const ReportedSurface& socket,
                           const SmallestBetween& smallest) {
  if (ball.gaps.bound.empty()) return nullptr;
  double largest = 0.0;
  std::size_t unbounded = 0;
  for (const ReportedSurface* v : {&ball, &socket}) {
    for (std::size_t i = 0; i < v->gaps.gap.size(); ++i) {
      const double bound = v->gaps.bound[i];
      if (std::isnan(v->gaps.gap[i])) continue;
      if (std::isinf(bound)) {
        ++unbounded;
        continue;
      }
      largest = std::max(largest, bound);
    }
  }
  return {{"largest", largest},
          {"vertices_without_bound", unbounded},
          {"smallest_gap_between", interval_json(smallest.low, smallest.high)},
          {"vertices_measured_on_the_faces", smallest.measured}};
}

nlohmann::json distances_json(const ReportedSurface& ball, const ReportedSurface& socket) {
  if (ball.gaps.distance.empty()) return nullptr;
  constexpr double kOverstated = 1.1;
  double low = std::numeric_limits<double>::infinity();
  double high = low;
  double largest = 1.0;
  std::size_t overstated = 0;
  for (const ReportedSurface* v : {&ball, &socket}) {
    for (std::size_t i = 0; i < v->gaps.gap.size(); ++i) {
      const DistanceBracket& distance = v->gaps.distance[i];
      low = std::min(low, distance.lower_mm);
      high = std::min(high, distance.upper_mm);
      const double bound = v->gaps.bound.empty() ? 0.0 : v->gaps.bound[i];
      const double ratio = (std::abs(v->gaps.gap[i]) - bound) / distance.upper_mm;
      if (std::isnan(ratio)) continue;
      largest = std::max(largest, ratio);
      if (ratio > kOverstated) ++overstated;
    }
  }
  return {{"smallest_between", nlohmann::json::array({number_json(low), number_json(high)})},
          {"gaps_above_it_by_a_tenth", overstated},
          {"largest_gap_over_it", largest}};
}

nlohmann::json certificate_json(const std::optional<Certificate>& found) {
  if (!found) return nullptr;
  const Certificate& certificate = *found;
  const auto verdict = [](bool impinged) { return impinged ? "impinged" : "clear"; };
  const auto& deepest = certificate.deepest;
  return {{"surfaces", verdict(certificate.surfaces_impinged)},
          {"vertices", verdict(certificate.vertices_impinged())},
          {"ball", vertex_verdicts_json(certificate.ball)},
          {"socket", vertex_verdicts_json(certificate.socket)},
          {"deepest_mm", deepest ? nlohmann::json(deepest->depth) : nlohmann::json(nullptr)},
          {"deepest_at", deepest ? nlohmann::json(name(deepest->kind)) : nlohmann::json(nullptr)}};
}

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/gaps.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "joint/document.hpp"
#include "sphere/scheme_choice.hpp"

namespace impinge {

void GapsRequest::check() const {
  if (by_tables() && max_error_mm)
    throw std::invalid_argument(
        "max_error_mm: is of gaps of the faces, and a scheme or precision asks for tables; leave one out");
  if (surfaces != Scanned::both && (asks_bounds() || asks(Output::distances)))
    throw std::invalid_argument(
        "surfaces: one alone has neither bounds, distances nor verdicts; ask for the outputs gaps alone");
  if (scheme) in_field("scheme", [&] { with_scheme(*scheme, []<class S>() {}); });
  if (by_tables())
    in_field("precision_deg",
             [&] { with_scheme(scheme_name(), [&]<class S>() { S::with_precision(precision()); }); });
}

std::vector<Impingement> GapsAnswer::impingement() const {
  std::vector<Impingement> levels{{0.0, "bone on bone", ball.bone, socket.bone}};
  if (touching > 0.0)
    levels.push_back({by_map ? std::nullopt : std::optional(touching), "cartilage on cartilage",
                      ball.cartilage, socket.cartilage});
  return levels;
}

GapHistograms GapsAnswer::gap_histogram() const {
  const auto of = [](const SurfaceAnswer& scan) {
    return scan.gap.empty() ? std::nullopt : std::optional(scan.histogram);
  };
  return {of(ball), of(socket)};
}

std::optional<DistancesDocument> GapsAnswer::euclidean_distance() const {
  constexpr double kOverstated = 1.1;
  if (ball.distance.empty()) return std::nullopt;
  DistancesDocument distances;
  auto& [lower, upper] = distances.smallest_between_mm;
  for (const SurfaceAnswer* of : {&ball, &socket}) {
    for (std::size_t i = 0; i < of->gap.size(); ++i) {
      const DistanceBracket& distance = of->distance[i];
      if (std::isnan(distance.upper_mm)) continue;  // a vertex of no face
      lower = std::min(lower, distance.lower_mm);
      upper = std::min(upper, distance.upper_mm);
      const double bound = of->bound.empty() ? 0.0 : of->bound[i];
      const double ratio = (std::abs(of->gap[i]) - bound) / distance.upper_mm;
      if (std::isnan(ratio)) continue;
      distances.largest_gap_over_it = std::max(distances.largest_gap_over_it, ratio);
      if (ratio > kOverstated) ++distances.gaps_above_it_by_a_tenth;
    }
  }
  return distances;
}

ColoursDocument GapsAnswer::colours() const {
  return {gap_levels(Surface::ball, touching), gap_levels(Surface::socket, touching)};
}

}  // namespace impinge

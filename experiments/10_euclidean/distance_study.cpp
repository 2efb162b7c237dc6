// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_euclidean/distance_study.hpp"

#include <cmath>

#include "10_euclidean/gap_bracket.hpp"
#include "harness/reference_cache.hpp"

namespace impinge::lab {
namespace {

std::size_t zone_of(const DistanceEnds& found) {
  if (found.edge_mm < found.gap_mm) return kFacingZones.size();
  std::size_t zone = 0;
  while (std::atan(found.slope) >= kFacingZones[zone].below_deg * kDegree) ++zone;
  return zone;
}

}  // namespace

std::vector<DistanceShare> distance_shares(const TriangleMesh& mesh, std::span<const Vec3> points,
                                           const std::filesystem::path& cache) {
  std::vector<DistanceShare> shares(kFacingZones.size() + 1);
  for (std::size_t k = 0; k < kFacingZones.size(); ++k) shares[k].zone = kFacingZones[k].name;
  shares.back().zone = kRimZone;
  const GapBracket bracket(mesh);
  const std::vector<double> distances = cached_closest_distances(cache, mesh, {.points = points});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const DistanceEnds found = bracket.at(points[i]);
    const double distance = distances[i];
    if (std::isinf(found.gap_mm) || distance == 0.0) continue;
    DistanceShare& share = shares[zone_of(found)];
    share.gap.push_back(found.gap_mm / distance);
    share.lower.push_back(found.lower_mm / distance);
    share.upper.push_back(found.upper_mm / distance);
    if (!(found.lower_mm <= distance && distance <= found.upper_mm)) ++share.outside;
  }
  return shares;
}

}  // namespace impinge::lab

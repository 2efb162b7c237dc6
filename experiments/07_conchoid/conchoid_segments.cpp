// SPDX-License-Identifier: GPL-3.0-or-later
#include "07_conchoid/conchoid_segments.hpp"

#include <algorithm>
#include <vector>

#include "curves/conchoid_origins.hpp"
#include "curves/conchoid_rays.hpp"
#include "curves/conchoid_spacing.hpp"
#include "sphere/direction.hpp"

namespace impinge::lab {
namespace {

constexpr std::size_t kPlaces = 901;  // on the arc, to find the extreme rates

}  // namespace

Result conchoid_segments(const ConchoidShape& shape, std::span<const std::size_t> ray_counts) {
  Result result{"conchoid_spacing", "How long are the segments between rays at equal angles?", {}, {}, {}};
  result.table.columns = {{"origin", "", "of the rays"},
                          {"height_mm", "mm", "of the origin on the axis"},
                          {"rays", "1", "from the apex to the rim"},
                          {"segment", "1", "from the apex on"},
                          {"phi_from_deg", "deg", "at the conchoid's origin"},
                          {"phi_to_deg", "deg", ""},
                          {"length_mm", "mm", "along the arc"}};
  for (const SamplingOrigin& at : sampling_origins(shape)) {
    for (const std::size_t rays : ray_counts) {
      const auto cuts = ray_cuts(shape, at.height, rays);
      const auto lengths = segment_lengths(shape, at.height, rays);
      for (std::size_t i = 0; i < lengths.size(); ++i) {
        result.table.add_row(
            {at.name, at.height, rays, i, cuts[i] / kDegree, cuts[i + 1] / kDegree, lengths[i]});
      }
    }
  }
  return result;
}

Result conchoid_origins(const ConchoidShape& shape) {
  Result result{"conchoid_origins", "How uneven are the segments of many rays from each origin?", {}, {}, {}};
  result.table.columns = {{"origin", "", "of the rays"},
                          {"height_mm", "mm", "of the origin on the axis"},
                          {"last_ray_deg", "deg", "angle of the ray through the rim"},
                          {"apex_mm_per_deg", "mm/deg", "arc per angle of ray at the apex"},
                          {"middle_mm_per_deg", "mm/deg", "at the ray halfway to the rim"},
                          {"rim_mm_per_deg", "mm/deg", "at the rim"},
                          {"smallest_mm_per_deg", "mm/deg", "of many places"},
                          {"largest_mm_per_deg", "mm/deg", "of many places"}};
  for (const SamplingOrigin& at : sampling_origins(shape)) {
    const auto rate = [&](double phi) { return spacing_rate(shape, at.height, phi) * kDegree; };
    std::vector<double> rates;
    for (const double phi : original_angles(kPlaces)) rates.push_back(rate(phi));
    const auto [smallest, largest] = std::ranges::minmax(rates);
    result.table.add_row({at.name, at.height, ray_angle(shape, at.height, kConchoidRim) / kDegree,
                          rates.front(), rate(ray_cuts(shape, at.height, 3)[1]), rates.back(), smallest,
                          largest});
  }
  return result;
}

}  // namespace impinge::lab

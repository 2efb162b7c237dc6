// SPDX-License-Identifier: GPL-3.0-or-later
#include "04_sampling_error/sampling_error.hpp"

#include <algorithm>

namespace impinge::lab {

Probes probes_of(const RadialSurface& surface, std::span<const Vec3> directions) {
  Probes probes;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    if (!surface.covers(directions[k])) continue;
    probes.place.push_back(k);
    probes.truth.push_back(surface.radius(directions[k]));
  }
  return probes;
}

double nearest_bound(const RadialSurface& surface, const Vec3& u, const Vec3& v) {
  const double slope = std::max({surface.slope(u), surface.slope(v), surface.slope((u + v).normalized())});
  return std::min(surface.radius(u), surface.radius(v)) * std::expm1(slope * angle_between(u, v));
}

}  // namespace impinge::lab

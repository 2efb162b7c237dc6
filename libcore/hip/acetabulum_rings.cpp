// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "hip/hip_rings.hpp"

namespace impinge {
namespace {

constexpr double kHidden = 0.03;  // radians by which the outer side stays behind the inner

// A point on the sphere of the socket, seen from its centre: at a share of the way from the pole to the rim
// and `hours` round the clock, `out` mm behind the surface and `back` radians inside the rim.
struct Place {
  double share;
  double hours;
  double out;
  double back;
};

Vec3 point_at(const HipSurface& hip, const Place& at) {
  const double polar = at.share * (rim_polar(hip, at.hours) - at.back);
  const Vec3 u = clock_direction(-hip.opening, hip.rim_clock, polar, at.hours);
  return hip.socket_centre + (inner_radius(hip, u) + at.out) * u;
}

}  // namespace

PointRings acetabulum_rings(const HipSurface& hip, double spacing) {
  const double rim = hip.parameters.half_opening * kDegree;
  const long bands = std::max(3L, std::lround(rim * hip.socket_radius / (kBandHeight * spacing)));
  PointRings rings;
  const auto append = [&](long band, double out, double back) {
    const double share = static_cast<double>(band) / static_cast<double>(bands);
    const double round = 2.0 * kPi * std::sin(share * rim) * (hip.socket_radius + out) / spacing;
    const auto n = band == 0 ? std::size_t{1} : static_cast<std::size_t>(std::max(6L, std::lround(round)));
    std::vector<Vec3> ring;
    for (std::size_t k = 0; k < n; ++k) {
      const double hours =
          12.0 * (static_cast<double>(k) + (band % 2 == 0 ? 0.0 : 0.5)) / static_cast<double>(n);
      ring.push_back(point_at(hip, {share, hours, out, back}));
    }
    rings.push_back(std::move(ring));
  };
  for (long band = 0; band <= bands; ++band) append(band, 0.0, 0.0);
  const double wall = hip.parameters.wall_thickness;
  if (wall == 0.0) return rings;
  for (long band = bands; band >= 0; --band) append(band, wall, kHidden);
  return rings;
}

}  // namespace impinge

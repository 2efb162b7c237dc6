// SPDX-License-Identifier: GPL-3.0-or-later
#include "phantoms/phantom_meshes.hpp"

#include <cmath>

#include <Eigen/Geometry>

#include "mesh/loft.hpp"

namespace impinge {
namespace {

constexpr double kFirst = 2e-4;   // radians, the first ring about a place of contact
constexpr double kGrowth = 1.15;  // of the next one
constexpr double kCoarsest = 0.15;

}  // namespace

TriangleMesh revolve(const Revolution& body) {
  const Vec3 x = body.axis.unitOrthogonal();
  const Vec3 y = body.axis.cross(x);
  std::vector<std::vector<Vec3>> rings;
  for (const LatheRing& ring : body.rings) {
    std::vector<Vec3>& points = rings.emplace_back();
    if (ring.polar == 0.0 || ring.polar == kPi) {
      points.push_back(body.centre + (ring.polar == 0.0 ? ring.radius : -ring.radius) * body.axis);
      continue;
    }
    for (std::size_t k = 0; k < body.sides; ++k) {
      const CosSin at = half_turn_fraction(2 * static_cast<long>(k), static_cast<long>(body.sides));
      points.push_back(body.centre + ring.radius * (std::cos(ring.polar) * body.axis +
                                                    std::sin(ring.polar) * (at.cos * x + at.sin * y)));
    }
  }
  return loft(rings);
}

std::vector<LatheRing> sphere_rings(double radius, double to, double step) {
  const auto steps = static_cast<std::size_t>(std::ceil(to / step));
  std::vector<LatheRing> rings;
  for (std::size_t k = 0; k < steps; ++k)
    rings.push_back({to * static_cast<double>(k) / static_cast<double>(steps), radius});
  rings.push_back({to, radius});
  return rings;
}

std::vector<LatheRing> focused_rings(double radius) {
  std::vector<LatheRing> rings{{0.0, radius}};
  for (double polar = kFirst; polar < kPi - kCoarsest; polar += std::min((kGrowth - 1.0) * polar, kCoarsest))
    rings.push_back({polar, radius});
  rings.push_back({kPi, radius});
  return rings;
}

}  // namespace impinge

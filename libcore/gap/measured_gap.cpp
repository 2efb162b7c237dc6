// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/measured_gap.hpp"

#include <algorithm>
#include <cmath>

namespace impinge {
namespace {

constexpr double kSteps = 64.0 * 0x1p-53;       // of a radius over the cosine
constexpr double kLengthSteps = 8.0 * 0x1p-53;  // of the length of the vertex
constexpr double kMostError = 1.0 / 16.0;       // of a radius; up to it kSteps holds (measured_gap.gappa)

// The radius of one face along u, which its cone contains.
RadiusRange radius_range(const TriangleCone& cone, const Vec3& u) {
  const double radius = cone.radius(u);
  const FacePlane& plane = cone.plane();
  const double error = kSteps * radius * (plane.normal.norm() * radius / plane.offset);
  RadiusRange corners;
  for (const Vec3& corner : cone.corners()) corners.include(corner.norm());
  if (std::isinf(cone.largest_slope()) || !(error < kMostError * radius)) return {0.0, corners.high};
  return {radius - error, radius + error};
}

// The radius of the layer along x: of the nearest or the farthest face that the ray meets.
RadiusRange layer_range(const NearFaces& surface, const Vec3& x, Layer layer) {
  const Vec3 u = x.stableNormalized();
  RadiusRange found;
  surface.any_hit(x, [&](std::uint32_t f, int side) {
    const TriangleCone cone = cone_of(surface.mesh(), surface.mesh().faces[f]);
    if (place_in_cone(cone.corners(), side, x) < 0) return false;
    const RadiusRange here = radius_range(cone, u);
    if (found.empty()) {
      found = here;
    } else if (layer == Layer::nearest) {
      found = {std::min(found.low, here.low), std::min(found.high, here.high)};
    } else {
      found = {std::max(found.low, here.low), std::max(found.high, here.high)};
    }
    return false;  // goes on to the next face
  });
  return found;
}

}  // namespace

CertifiedGap measured_gap(Surface of, const NearFaces& faces, const Vec3& x) {
  if (x.isZero(0.0)) return {};
  const RadiusRange range = layer_range(faces, x, facing_layer(other(of)));
  if (range.empty()) return {};
  const double length = x.norm();
  const double error = kLengthSteps * length;
  const RadiusRange gap = signed_gap(of, range, length);
  return certified(gap.low - error, gap.high + error, Cover::whole);
}

SmallestBetween smallest_between(const BoundedScan& ball, const BoundedScan& socket) {
  SmallestBetween found;
  for (const BoundedScan* scan : {&ball, &socket}) {
    for (std::size_t i = 0; i < scan->gap.size(); ++i) {
      if (!std::isnan(scan->gap[i])) found.high = std::min(found.high, scan->gap[i] + scan->bound[i]);
    }
  }
  const double by_bounds = found.high;
  for (const BoundedScan* scan : {&ball, &socket}) {
    for (std::size_t i = 0; i < scan->gap.size(); ++i) {
      const double low = scan->gap[i] - scan->bound[i];
      if (std::isnan(scan->gap[i]) || low > by_bounds) continue;
      const CertifiedGap exact = measured_gap(scan->scanned, scan->asked, scan->places[i]);
      ++found.measured;
      if (exact.cover == Cover::none) continue;
      found.low = std::min(found.low, exact.low);
      found.high = std::min(found.high, exact.high);
    }
  }
  return found;
}

}  // namespace impinge

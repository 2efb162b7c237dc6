// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/surface_plane.hpp"

#include <algorithm>
#include <cmath>

#include "sphere/infinity.hpp"

namespace impinge {

SurfacePlane surface_plane(const TriangleCone& cone) {
  const FacePlane& face = cone.plane();
  SurfacePlane plane{.cone = cone};
  plane.slope = cone.edge_on() ? kInfinity : cone.largest_slope();
  plane.condition = kInfinity;
  for (const Vec3& x : cone.corners()) plane.largest_radius = std::max(plane.largest_radius, x.norm());
  if (face.offset > 0.0 && std::isfinite(plane.slope)) {
    plane.inverse = face.normal / face.offset;
    plane.distance = cone.plane_distance();
    plane.least_radius = plane.distance;
    plane.condition = face.size * plane.largest_radius / face.offset;
  }
  for (const Vec3& x : cone.corners()) plane.middle += x.normalized();
  plane.middle.normalize();
  // A cap of less than a quarter turn that holds the corners holds the face.
  for (const Vec3& x : cone.corners())
    plane.chord = std::max(plane.chord, (x.normalized() - plane.middle).norm());
  if (plane.chord > 1.0) plane.chord = 2.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 across = cone.side() * cone.corners()[k].cross(cone.corners()[(k + 1) % 3]);
    const double length = across.norm();
    plane.inward[k] = length > 0.0 ? Vec3(across / length) : Vec3::Zero();
  }
  return plane;
}

bool clearly_apart(const SurfacePlane& a, const SurfacePlane& b) {
  if (a.cone.edge_on() || b.cone.edge_on()) return true;
  if ((a.middle - b.middle).norm() > a.chord + b.chord + kDirectionSlack) return true;
  const auto beyond_an_edge = [](const SurfacePlane& here, const SurfacePlane& there) {
    return std::ranges::any_of(here.inward, [&there](const Vec3& inward) {
      const double slack = kDirectionSlack * there.largest_radius;
      return std::ranges::all_of(there.cone.corners(), [&](const Vec3& x) { return inward.dot(x) < -slack; });
    });
  };
  return beyond_an_edge(a, b) || beyond_an_edge(b, a);
}

PlaneRange range_within(const SurfacePlane& plane, const DirectionCap& cap) {
  if (!std::isfinite(plane.slope)) return {0.0, plane.largest_radius, kInfinity};
  const double cosine = std::clamp(plane.inverse.dot(cap.axis) * plane.distance, -1.0, 1.0);
  const double psi = std::acos(cosine);
  const double steepest = psi + cap.radius + 1e-9;
  PlaneRange range{plane.least_radius, plane.largest_radius, plane.slope};
  if (psi > cap.radius)
    range.least =
        std::max(range.least, plane.distance / std::cos(std::min(psi - cap.radius, 0.5 * kPi - 1e-9)));
  range.least *= 1.0 - kDirectionSlack;
  if (steepest < 0.5 * kPi) {
    range.largest = std::min(range.largest, plane.distance / std::cos(steepest));
    range.slope = std::min(range.slope, std::tan(steepest));
  }
  range.largest *= 1.0 + kDirectionSlack;
  range.slope *= 1.0 + kDirectionSlack;
  return range;
}

}  // namespace impinge

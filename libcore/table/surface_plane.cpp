// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/surface_plane.hpp"

#include <algorithm>
#include <cmath>

#include "sphere/infinity.hpp"

namespace impinge {

Vec3 edge_normal(const Vec3& from, const Vec3& to) {
  constexpr double kRoundings = 8.0 * 0x1p-53;
  const Vec3 along = to - from;
  const Vec3 normal = from.cross(along);
  const double length = normal.norm();
  if (!(kRoundings * from.norm() * along.norm() < 0.5 * kDirectionSlack * length)) return Vec3::Zero();
  return normal / length;
}

SurfacePlane surface_plane(const TriangleCone& cone) {
  const FacePlane& face = cone.plane();
  SurfacePlane plane{.cone = cone};
  plane.slope = cone.edge_on() ? kInfinity : cone.largest_slope();
  plane.doubt = kInfinity;
  for (const Vec3& x : cone.corners()) plane.largest_radius = std::max(plane.largest_radius, x.norm());
  if (face.offset > 0.0 && std::isfinite(plane.slope)) {
    plane.inverse = face.normal / face.offset;
    plane.distance = cone.plane_distance();
    plane.least_radius = plane.distance;
    plane.doubt = kPlaneRoundings * face.size * plane.largest_radius / face.offset;
  }
  for (const Vec3& x : cone.corners()) plane.middle += x.normalized();
  plane.middle.normalize();
  // A cap of less than a quarter turn that holds the corners holds the face.
  for (const Vec3& x : cone.corners())
    plane.chord = std::max(plane.chord, (x.normalized() - plane.middle).norm());
  if (plane.chord > 1.0) plane.chord = 2.0;
  for (std::size_t k = 0; k < 3; ++k) {
    plane.inward[k] = cone.side() * edge_normal(cone.corners()[k], cone.corners()[(k + 1) % 3]);
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
  constexpr double kMostDoubt = 0.01;  // of a plane that says anything
  const double doubt = plane.doubt + kDirectionSlack;
  if (!std::isfinite(plane.slope) || !(doubt < kMostDoubt)) return {0.0, plane.largest_radius, kInfinity};
  const double psi = angle_between(plane.inverse, cap.axis);  // the arccosine loses half of its digits near 0
  const double nearest = psi - cap.radius - doubt;
  const double steepest = psi + cap.radius + doubt;
  PlaneRange range{plane.least_radius, plane.largest_radius, plane.slope};
  if (nearest > 0.0)
    range.least = std::max(range.least, plane.distance / std::cos(std::min(nearest, 0.5 * kPi)));
  if (steepest < 0.5 * kPi) {
    range.largest = std::min(range.largest, plane.distance / std::cos(steepest));
    range.slope = std::min(range.slope, std::tan(steepest));
  }
  return {range.least * (1.0 - doubt), range.largest * (1.0 + doubt),
          range.slope + (1.0 + range.slope) * doubt};
}

}  // namespace impinge

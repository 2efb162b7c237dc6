// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/chart.hpp"

#include <cmath>
#include <cstddef>

namespace impinge::lab {
namespace {

ChartPoint chart_point(const Vec3& x) {
  const auto [phi, theta] = to_angles(x);
  return {theta, phi, x.norm()};
}

// The chart point of b, unrolled so that the edge from a (chart point `from`) runs as on the sphere. Azimuth
// grows along it exactly if the north pole lies to its left; near half a turn the rounded step alone does not
// know.
ChartPoint unrolled(const Vec3& a, const ChartPoint& from, const Vec3& b) {
  ChartPoint to = chart_point(b);
  double step = std::remainder(to.theta - from.theta, 2.0 * kPi);
  if (std::abs(step) > 0.5 * kPi && step * orientation(a, b, Vec3::UnitZ()) < 0.0) {
    step -= std::copysign(2.0 * kPi, step);
  }
  to.theta = from.theta + step;
  return to;
}

bool on_axis(const Vec3& x) { return x.x() == 0.0 && x.y() == 0.0; }

// The region (a b b0 a0) of Figure 34, a0 and b0 at the pole: the chart of the triangle (pole, a, b).
void add_polar_region(const Vec3& from, const Vec3& to, const ChartPoint& pole,
                      std::vector<ChartTriangle>& triangles) {
  const ChartPoint a = chart_point(from);
  const ChartPoint b = unrolled(from, a, to);
  const ChartPoint a0{a.theta, pole.phi, pole.radius};
  const ChartPoint b0{b.theta, pole.phi, pole.radius};
  triangles.push_back({a, b, b0});
  triangles.push_back({a, b0, a0});
}

// Cuts the face at a pole that it holds: one region for each edge that does not pass through the pole.
void add_polar_regions(const TriangleCone& cone, const Vec3& axis, std::vector<ChartTriangle>& triangles) {
  const ChartPoint pole{0.0, axis.z() > 0.0 ? 0.0 : kPi, cone.radius(axis)};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& a = cone.corners()[k];
    const Vec3& b = cone.corners()[(k + 1) % 3];
    if (on_axis(a) || on_axis(b) || orientation(a, b, axis) == 0) continue;
    add_polar_region(a, b, pole, triangles);
  }
}

}  // namespace

std::vector<ChartTriangle> chart_triangles(const TriangleCone& cone) {
  std::vector<ChartTriangle> triangles;
  const Vec3 north = Vec3::UnitZ();
  if (cone.contains(north)) add_polar_regions(cone, north, triangles);
  if (cone.contains(-north)) add_polar_regions(cone, -north, triangles);
  if (triangles.empty()) {
    const auto& [p, q, r] = cone.corners();
    const ChartPoint a = chart_point(p);
    const ChartPoint b = unrolled(p, a, q);
    triangles.push_back({a, b, unrolled(q, b, r)});
  }
  return triangles;
}

}  // namespace impinge::lab

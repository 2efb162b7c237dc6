// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/chart.hpp"

#include <cmath>
#include <cstddef>

namespace impinge {
namespace {

ChartPoint chart_point(const Vec3& x) {
  const auto [phi, theta] = to_angles(x);
  return {theta, phi, x.norm()};
}

// The azimuth of `point` that is nearest to that of `reference`, over the seam if need be.
ChartPoint unrolled(ChartPoint point, const ChartPoint& reference) {
  point.theta = reference.theta + std::remainder(point.theta - reference.theta, 2.0 * kPi);
  return point;
}

bool on_axis(const Vec3& x) { return x.x() == 0.0 && x.y() == 0.0; }

// The region (a b b0 a0) of Figure 34, a0 and b0 at the pole: the chart of the triangle (pole, a, b).
void add_polar_region(const ChartPoint& a, const ChartPoint& far_end, const ChartPoint& pole,
                      std::vector<ChartTriangle>& triangles) {
  const ChartPoint b = unrolled(far_end, a);
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
    add_polar_region(chart_point(a), chart_point(b), pole, triangles);
  }
}

}  // namespace

std::vector<ChartTriangle> chart_triangles(const TriangleCone& cone) {
  std::vector<ChartTriangle> triangles;
  const Vec3 north = Vec3::UnitZ();
  if (cone.contains(north)) add_polar_regions(cone, north, triangles);
  if (cone.contains(-north)) add_polar_regions(cone, -north, triangles);
  if (triangles.empty()) {
    const ChartPoint a = chart_point(cone.corners()[0]);
    const ChartPoint b = unrolled(chart_point(cone.corners()[1]), a);
    triangles.push_back({a, b, unrolled(chart_point(cone.corners()[2]), b)});
  }
  return triangles;
}

}  // namespace impinge

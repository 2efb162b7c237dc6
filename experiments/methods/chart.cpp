// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/chart.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "methods/thesis_raster.hpp"

namespace impinge::lab {
namespace {

ChartPoint chart_point(const Vec3& x) {
  const auto [phi, theta] = to_angles(x);
  return {theta, phi, x.norm()};
}

// The chart point of b, unrolled so that the edge from a (chart point `from`) runs as on the sphere. Azimuth
// grows along it if and only if the north pole is to its left. Near half a turn the rounded step alone would
// not tell.
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

// Twice the signed area of the flat triangle (a, b, p) on the chart.
double flat_area(Angles a, Angles b, Angles p) {
  return (b.theta - a.theta) * (p.phi - a.phi) - (b.phi - a.phi) * (p.theta - a.theta);
}

bool in_direct_map(const TriangleCone& cone, Angles p) {
  std::array<double, 3> area{};
  for (std::size_t k = 0; k < 3; ++k) {
    area[k] = flat_area(to_angles(cone.corners()[k]), to_angles(cone.corners()[(k + 1) % 3]), p);
  }
  return (area[0] >= 0.0 && area[1] >= 0.0 && area[2] >= 0.0) ||
         (area[0] <= 0.0 && area[1] <= 0.0 && area[2] <= 0.0);
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

std::vector<EntryCoverage> chart_coverage(const TriangleMesh& mesh, const Rsid& scheme) {
  const RadialTable<Rsid> drawn = fill_thesis(mesh, scheme, Layer::nearest);
  std::vector<EntryCoverage> covered;
  for (std::size_t i = 0; i < scheme.size(); ++i) {
    EntryCoverage entry{.entry = i, .met_radius = kNoSurface, .drawn_radius = drawn.radii()[i]};
    entry.drawn = !std::isnan(entry.drawn_radius);
    const Vec3 u = scheme.direction(i);
    // By index in the table: the columns of a pole row have different azimuths but the same direction.
    const std::size_t row = i / scheme.columns();
    const std::size_t column = i % scheme.columns();
    const Angles place{static_cast<double>(row) * scheme.spacing(),
                       static_cast<double>(column) * scheme.spacing()};
    for (const Face& face : mesh.faces) {
      const TriangleCone cone = cone_of(mesh, face);
      if (cone.contains(u)) entry.met = true, entry.met_radius = cone.radius(u);
      if (in_direct_map(cone, place)) entry.direct = true;
    }
    if (entry.met || entry.drawn || entry.direct) covered.push_back(entry);
  }
  return covered;
}

TriangleMesh faces_along(const TriangleMesh& mesh, const Vec3& direction) {
  TriangleMesh found{mesh.vertices, {}};
  for (const Face& face : mesh.faces) {
    if (cone_of(mesh, face).contains(direction)) found.faces.push_back(face);
  }
  return found;
}

}  // namespace impinge::lab

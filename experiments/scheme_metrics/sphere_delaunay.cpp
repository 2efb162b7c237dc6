// SPDX-License-Identifier: GPL-3.0-or-later
#include "scheme_metrics/sphere_delaunay.hpp"

#include <cmath>

#include <Eigen/Geometry>

namespace impinge {
namespace {

// Area of a spherical triangle, negative when clockwise: tan(area / 2) = det / (1 + ab + bc + ca), Van
// Oosterom and Strackee 1983. The determinant of differences keeps the digits of small triangles.
double signed_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double determinant = a.dot((b - a).cross(c - a));
  return 2.0 * std::atan2(determinant, 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
}

// The corners are counter-clockwise, so that the normal points to the centre outside.
EmptyCircle circle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 centre = (b - a).cross(c - a).normalized();
  return {centre, angle_between(centre, a)};
}

}  // namespace

SphereDelaunay sphere_delaunay(std::span<const Vec3> entries) {
  SphereDelaunay delaunay;
  delaunay.distinct = distinct_directions(entries);
  const std::vector<Vec3>& u = delaunay.distinct.direction;
  delaunay.triangles = delaunay_triangles(u);
  delaunay.gaps.reserve(delaunay.triangles.size());
  for (const auto& [a, b, c] : delaunay.triangles) delaunay.gaps.push_back(circle(u[a], u[b], u[c]));
  return delaunay;
}

EmptyCircle widest_gap(const SphereDelaunay& delaunay, double z_max) {
  EmptyCircle widest;
  for (const EmptyCircle& gap : delaunay.gaps) {
    if (gap.radius > widest.radius && std::abs(gap.centre.z()) <= z_max) widest = gap;
  }
  return widest;
}

// Each triangle gives to each corner the part that is nearest to it, between the corner, the middles of both
// sides and the centre. Where the centre is outside some parts are negative and make up for it next door.
std::vector<double> voronoi_areas(const SphereDelaunay& delaunay) {
  const std::vector<Vec3>& u = delaunay.distinct.direction;
  std::vector<double> areas(u.size(), 0.0);
  for (std::size_t i = 0; i < delaunay.triangles.size(); ++i) {
    const Vec3& centre = delaunay.gaps[i].centre;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = delaunay.triangles[i][k];
      const std::size_t b = delaunay.triangles[i][(k + 1) % 3];
      const Vec3 middle = (u[a] + u[b]).normalized();
      areas[a] += signed_area(u[a], middle, centre);
      areas[b] += signed_area(middle, u[b], centre);
    }
  }
  return areas;
}

std::vector<double> entry_areas(const SphereDelaunay& delaunay) {
  const std::vector<double> areas = voronoi_areas(delaunay);
  std::vector<double> shares;
  shares.reserve(delaunay.distinct.of_entry.size());
  for (const std::size_t place : delaunay.distinct.of_entry) {
    shares.push_back(areas[place] / static_cast<double>(delaunay.distinct.entries[place]));
  }
  return shares;
}

}  // namespace impinge

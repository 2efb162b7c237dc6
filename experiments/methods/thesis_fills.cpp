// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/thesis_fills.hpp"

#include <cmath>

#include <Eigen/Geometry>

#include "table/error_bound.hpp"

namespace impinge::lab {
namespace {

double twice_area(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a).norm(); }

double met_at(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& u) {
  const Vec3 normal = (b - a).cross(c - a);
  const double radius = normal.dot(a) / normal.dot(u);
  if (!(radius > 0.0)) return kNoSurface;
  const Vec3 x = radius * u;
  const double areas = twice_area(x, a, b) + twice_area(x, b, c) + twice_area(x, c, a);
  return areas <= (1.0 + kAreaSlack) * normal.norm() ? radius : kNoSurface;
}

}  // namespace

double thesis_ray_radius(const TriangleMesh& mesh, const Vec3& u, Layer layer) {
  double kept = kNoSurface;
  for (const Face& face : mesh.faces) {
    const double radius = met_at(mesh.vertices[face[0]], mesh.vertices[face[1]], mesh.vertices[face[2]], u);
    if (radius > 0.0) keep(kept, radius, layer);
  }
  return kept;
}

ScanVerdicts compare_as_written(std::span<const double> gap, Surface scanned) {
  ScanVerdicts verdicts;
  for (const double g : gap) {
    if (std::isnan(g)) continue;
    ++verdicts.met;
    if (g <= 0.0) ++verdicts.by_gap;
    if (scanned == Surface::ball ? g <= 0.0 : g >= 0.0) ++verdicts.as_written;
  }
  return verdicts;
}

double resampling_bound(const TriangleMesh& mesh, double precision_deg) {
  const double drawn = thesis_raster_bound(mesh);
  if (std::isinf(drawn)) return drawn;  // a face is edge-on
  double radius = 0.0;
  double slope = 0.0;
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    slope = std::max(slope, cone.largest_slope());
    for (const Vec3& x : cone.corners()) radius = std::max(radius, x.norm());
  }
  const Rsid raster = raster_for(precision_deg);
  return drawn + radius * first_order_share(slope, raster.stencil_radius() + direction_doubt(raster));
}

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/thesis_pairwise.hpp"

#include <Eigen/Geometry>

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

}  // namespace impinge::lab

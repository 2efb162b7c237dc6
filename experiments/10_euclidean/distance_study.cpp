// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_euclidean/distance_study.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/triangle_distance.hpp"
#include "reference/closest_point.hpp"
#include "sphere/infinity.hpp"
#include "table/near_faces.hpp"

namespace impinge::lab {
namespace {

// Where the ray of a point ends: on the nearest face that it meets.
struct RayEnd {
  double gap_mm = kInfinity;  // from the point to that face; infinite where no face is met
  double slope = 0.0;         // tangent of the angle between ray and normal
};

RayEnd ray_end(const NearFaces& faces, const Vec3& x) {
  RayEnd end;
  const Vec3 u = x.normalized();
  for (const std::uint32_t f : faces.near(x).faces) {
    const TriangleCone cone = cone_of(faces.mesh(), faces.mesh().faces[f]);
    const double gap = cone.contains(u) ? std::abs(x.norm() - cone.radius(u)) : kInfinity;
    if (gap >= end.gap_mm) continue;
    const Vec3& normal = cone.plane().normal;
    end = {gap, normal.cross(u).norm() / std::abs(normal.dot(u))};
  }
  return end;
}

std::size_t zone_of(const NearFaces& faces, const Vec3& x, const RayEnd& end) {
  const TriangleMesh& mesh = faces.mesh();
  const bool rim = std::ranges::any_of(faces.jumps(), [&](const JumpEdge& edge) {
    const double squared = squared_distance_to_segment(x, mesh.vertices[edge.from], mesh.vertices[edge.to]);
    return squared < end.gap_mm * end.gap_mm;
  });
  if (rim) return kFacingZones.size();
  std::size_t zone = 0;
  while (std::atan(end.slope) >= kFacingZones[zone].below_deg * kDegree) ++zone;
  return zone;
}

}  // namespace

std::vector<DistanceShare> distance_shares(const TriangleMesh& mesh, std::span<const Vec3> points) {
  std::vector<DistanceShare> shares(kFacingZones.size() + 1);
  for (std::size_t k = 0; k < kFacingZones.size(); ++k) shares[k].zone = kFacingZones[k].name;
  shares.back().zone = kRimZone;
  const NearFaces faces(mesh, 0.0);
  const std::vector<double> distances = closest_distances(mesh, {.points = points});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const RayEnd end = ray_end(faces, points[i]);
    if (std::isinf(end.gap_mm) || distances[i] == 0.0) continue;
    shares[zone_of(faces, points[i], end)].gap.push_back(end.gap_mm / distances[i]);
  }
  return shares;
}

}  // namespace impinge::lab

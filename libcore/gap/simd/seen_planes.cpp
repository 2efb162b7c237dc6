// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/simd/seen_planes.hpp"

#include <algorithm>

namespace impinge {
namespace {

constexpr double kInOnePlane = 0x1p-26;

Vec3 seen_plane(const TriangleCone& cone) {
  if (cone.edge_on()) return Vec3::Zero();
  double farthest = 0.0;
  for (const Vec3& v : cone.corners()) farthest = std::max(farthest, v.norm());
  if (!(cone.plane().normal.norm() * farthest <= kSteepest * cone.plane().offset)) return Vec3::Zero();
  return cone.plane().normal / cone.plane().offset;
}

}  // namespace

std::vector<Vec3> seen_planes(const TriangleMesh& mesh) {
  std::vector<Vec3> planes;
  planes.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) planes.push_back(seen_plane(cone_of(mesh, face)));
  return planes;
}

std::optional<int> bend_of(const SeenMesh& seen, std::span<const std::uint32_t> faces) {
  bool inner = true;
  bool outer = true;
  for (const std::uint32_t g : faces) {
    const Vec3& plane = seen.planes[g];
    if (plane.isZero(0.0)) return {};
    for (const std::uint32_t f : faces) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& v = corner(seen.mesh, seen.mesh.faces[f], k);
        if (plane.squaredNorm() * v.squaredNorm() > kSteepest * kSteepest) return {};
        const double beyond = plane.dot(v) - 1.0;
        inner = inner && beyond <= kInOnePlane;
        outer = outer && beyond >= -kInOnePlane;
      }
    }
    if (!inner && !outer) return {};
  }
  return inner ? 1 : -1;
}

}  // namespace impinge

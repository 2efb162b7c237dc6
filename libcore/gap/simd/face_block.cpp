// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/simd/face_block.hpp"

#include <algorithm>

namespace impinge {
namespace {

// How far the normal of an edge may be off in double, beside the 2^-24 of its float.
constexpr double kCertainEdge = 0x1p-28;

// The normal is zero for an edge without certain digits: every direction that the other edges do not exclude
// is then in doubt.
Eigen::Vector3f edge_normal(const TriangleCone& cone, std::size_t k) {
  const Vec3& from = cone.corners()[k];
  const Vec3& to = cone.corners()[(k + 1) % 3];
  const Vec3 normal = cone.side() * from.cross(to);
  const double doubt = kPlaneTestError * from.norm() * to.norm();
  if (doubt > kCertainEdge * normal.norm()) return Eigen::Vector3f::Zero();
  return normal.stableNormalized().cast<float>();
}

// Sets lane k of rows of coordinates.
void set_lane(std::array<FaceBlock::Row, 3>& rows, std::size_t k, const Eigen::Vector3f& x) {
  for (std::size_t i = 0; i < 3; ++i) rows[i][k] = x[static_cast<Eigen::Index>(i)];
}

}  // namespace

std::vector<FaceLane> face_lanes(const SeenMesh& seen, Layer layer) {
  const double turn = layer == Layer::nearest ? 1.0 : -1.0;
  std::vector<FaceLane> faces(seen.mesh.faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const TriangleCone cone = cone_of(seen.mesh, seen.mesh.faces[f]);
    for (std::size_t k = 0; k < 3; ++k) faces[f].edge[k] = edge_normal(cone, k);
    faces[f].plane = (turn * seen.planes[f]).cast<float>();
  }
  return faces;
}

FaceBlock face_block(std::span<const FaceLane> all, std::span<const std::uint32_t> faces) {
  FaceBlock block;
  for (std::size_t k = 0; k < FaceBlock::kFaces; ++k) {
    const FaceLane& face = all[faces[std::min(k, faces.size() - 1)]];
    for (std::size_t e = 0; e < 3; ++e) set_lane(block.edge[e], k, face.edge[e]);
    set_lane(block.plane, k, face.plane);
  }
  return block;
}

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/simd/face_block.hpp"

#include <algorithm>

namespace impinge {
namespace {

// What the normal of an edge may be off by in double, next to the 2^-24 of its float.
constexpr double kCertainEdge = 0x1p-28;

// Lane k of rows of coordinates.
void set_lane(std::array<FaceBlock::Row, 3>& rows, std::size_t k, const Vec3& x) {
  for (std::size_t i = 0; i < 3; ++i) rows[i][k] = static_cast<float>(x[static_cast<Eigen::Index>(i)]);
}

// A normal of zero, of an edge without certain digits, leaves every direction in doubt that the other edges
// do not exclude.
void set_edges(const TriangleCone& cone, std::size_t lane, FaceBlock& block) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& from = cone.corners()[k];
    const Vec3& to = cone.corners()[(k + 1) % 3];
    const Vec3 normal = cone.side() * from.cross(to);
    const double doubt = kPlaneTestError * from.norm() * to.norm();
    const bool certain = doubt <= kCertainEdge * normal.norm();
    set_lane(block.edge[k], lane, certain ? Vec3(normal.stableNormalized()) : Vec3(Vec3::Zero()));
  }
}

}  // namespace

std::vector<FaceBlock> face_blocks(const SeenMesh& seen, std::span<const std::uint32_t> order, Layer layer) {
  constexpr std::size_t kFaces = FaceBlock::kFaces;
  const double turn = layer == Layer::nearest ? 1.0 : -1.0;
  std::vector<FaceBlock> blocks((order.size() + kFaces - 1) / kFaces);
  for (std::size_t place = 0; place < kFaces * blocks.size(); ++place) {
    const std::uint32_t f = order[std::min(place, order.size() - 1)];
    FaceBlock& block = blocks[place / kFaces];
    set_edges(cone_of(seen.mesh, seen.mesh.faces[f]), place % kFaces, block);
    set_lane(block.plane, place % kFaces, turn * seen.planes[f]);
  }
  return blocks;
}

}  // namespace impinge

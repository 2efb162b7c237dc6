// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "gap/simd/exact_cells.hpp"

namespace impinge {
namespace {

// Is x, by doubles, certainly outside of the cone over a face: on one side of an edge and on the other side
// of another?
bool clearly_outside(const std::array<Vec3, 3>& corners, const Vec3& x, double length) {
  bool above = false;
  bool below = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& from = corners[k];
    const Vec3& to = corners[(k + 1) % 3];
    const double side = from.cross(to).dot(x);
    const double doubt = kPlaneTestError * from.norm() * to.norm() * length;
    above = above || side > doubt;
    below = below || side < -doubt;
  }
  return above && below;
}

}  // namespace

double exact_gap(const ExactCells& cells, std::size_t cell, const Vec3& x, Surface scanned) {
  if (!x.allFinite()) return kNoSurface;
  const Vec3 u = x.stableNormalized();
  const double length = x.norm();
  const ExactCell& asked = cells.cells[cell];
  double radius = kNoSurface;
  for (std::size_t k = 0; k < FaceBlock::kFaces * asked.count; ++k) {
    const Face& face = cells.mesh.faces[cells.face[FaceBlock::kFaces * (asked.first - 1) + k]];
    if (clearly_outside(corners_of(cells.mesh, face), x, length)) continue;
    const TriangleCone cone = cone_of(cells.mesh, face);
    if (place_in_cone(cone.corners(), cone.side(), x) >= 0) keep(radius, cone.radius(u), cells.layer);
  }
  return signed_gap(scanned, radius, length);
}

}  // namespace impinge

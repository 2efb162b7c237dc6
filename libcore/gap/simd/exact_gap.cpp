// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "gap/simd/exact_cells.hpp"

namespace impinge {

double exact_gap(const ExactCells& cells, std::size_t cell, const Vec3& x, Surface scanned) {
  if (!x.allFinite()) return kNoSurface;
  const Vec3 u = x.stableNormalized();
  const ExactCell& asked = cells.cells[cell];
  double radius = kNoSurface;
  for (std::size_t k = asked.first; k < asked.first + asked.count; ++k) {
    const std::size_t begin = FaceBlock::kFaces * cells.listed[k];
    const std::size_t end = std::min(begin + FaceBlock::kFaces, cells.face.size());
    for (std::size_t place = begin; place < end; ++place) {
      const TriangleCone cone = cone_of(cells.mesh, cells.mesh.faces[cells.face[place]]);
      if (place_in_cone(cone.corners(), cone.side(), x) >= 0) keep(radius, cone.radius(u), cells.layer);
    }
  }
  return signed_gap(scanned, radius, x.norm());
}

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/exact_side.hpp"

#include <algorithm>

#include "sphere/plane_side.hpp"

namespace impinge {
namespace {

using Corners = std::array<Vec3, 3>;

Corners corners_of(const TriangleMesh& surface, std::uint32_t f) {
  const Face& face = surface.faces[f];
  return {corner(surface, face, 0), corner(surface, face, 1), corner(surface, face, 2)};
}

// Does the ray of x meet a face for which `order`, +1 with x beyond it and -1 with x before it, is not
// opposite? side is the orientation of its corners.
bool meets(const Corners& corners, int side, const Vec3& x, int order) {
  if (place_in_cone(corners, side, x) < 0) return false;
  return order * side * plane_side(corners[0], corners[1], corners[2], x) >= 0;
}

}  // namespace

bool exactly_impinged(Surface of, const TriangleMesh& met, const FaceIndex& index, const Vec3& x) {
  if (x.isZero(0.0)) return of == Surface::socket && !index.empty();
  return std::ranges::any_of(index.near(x).faces, [&](std::uint32_t f) {
    return meets(corners_of(met, f), index.face(f).side, x, gap_sign<int>(of));
  });
}

bool exactly_impinged(Surface of, const NearFaces& met, const Vec3& x) {
  if (x.isZero(0.0)) return of == Surface::socket && !met.empty();
  return met.any_met(x, [&](std::uint32_t f, int side) {
    return meets(corners_of(met.mesh(), f), side, x, gap_sign<int>(of));
  });
}

}  // namespace impinge

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

bool meets(const TriangleMesh& surface, const FaceIndex& index, const Vec3& x, int order) {
  return std::ranges::any_of(index.near(x).faces, [&](std::uint32_t f) {
    return meets(corners_of(surface, f), index.face(f).side, x, order);
  });
}

bool meets(const NearFaces& surface, const Vec3& x, int order) {
  return surface.any_met(
      x, [&](std::uint32_t f, int side) { return meets(corners_of(surface.mesh(), f), side, x, order); });
}

}  // namespace

bool on_or_beyond(const TriangleMesh& surface, const FaceIndex& index, const Vec3& x) {
  return !x.isZero(0.0) && meets(surface, index, x, 1);
}

bool on_or_within(const TriangleMesh& surface, const FaceIndex& index, const Vec3& x) {
  return x.isZero(0.0) ? !index.empty() : meets(surface, index, x, -1);
}

bool on_or_beyond(const NearFaces& surface, const Vec3& x) { return !x.isZero(0.0) && meets(surface, x, 1); }

bool on_or_within(const NearFaces& surface, const Vec3& x) {
  return x.isZero(0.0) ? !surface.empty() : meets(surface, x, -1);
}

}  // namespace impinge

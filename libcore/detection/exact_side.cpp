// SPDX-License-Identifier: GPL-3.0-or-later
#include "detection/exact_side.hpp"

#include <algorithm>

#include "sphere/plane_side.hpp"

namespace impinge {
namespace {

// Does the ray of x meet a face for which `order`, +1 with x beyond it and -1 with x before it, is not
// opposite?
bool meets(const TriangleMesh& surface, const FaceIndex& index, const Vec3& x, int order) {
  return std::ranges::any_of(index.near(x).faces, [&](std::uint32_t f) {
    const int side = index.face(f).side;
    const Face& face = surface.faces[f];
    const std::array<Vec3, 3> corners{corner(surface, face, 0), corner(surface, face, 1),
                                      corner(surface, face, 2)};
    if (place_in_cone(corners, side, x) < 0) return false;
    return order * side * plane_side(corners[0], corners[1], corners[2], x) >= 0;
  });
}

}  // namespace

bool on_or_beyond(const TriangleMesh& surface, const FaceIndex& index, const Vec3& x) {
  return !x.isZero(0.0) && meets(surface, index, x, 1);
}

bool on_or_within(const TriangleMesh& surface, const FaceIndex& index, const Vec3& x) {
  return x.isZero(0.0) ? index.size() > 0 : meets(surface, index, x, -1);
}

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/exact_side.hpp"

#include "sphere/plane_side.hpp"

namespace impinge {

bool exactly_impinged(Surface of, const NearFaces& faces, const Vec3& x) {
  if (x.isZero(0.0)) return of == Surface::socket && !faces.empty();
  // Looks for a face with x on it or on the impinged side. The order is +1 if x is beyond it, -1 if before.
  return faces.any_hit(x, [&](std::uint32_t f, int side) {
    const auto corners = corners_of(faces.mesh(), faces.mesh().faces[f]);
    if (place_in_cone(corners, side, x) < 0) return false;
    return gap_sign<int>(of) * side * plane_side(corners[0], corners[1], corners[2], x) >= 0;
  });
}

}  // namespace impinge

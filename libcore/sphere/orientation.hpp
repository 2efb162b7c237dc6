// SPDX-License-Identifier: GPL-3.0-or-later
// Decides exactly on which side of a plane through the centre a direction lies. With exact signs a ray
// through an edge or vertex of a closed surface never slips through.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "sphere/direction.hpp"

namespace impinge {

/// Sign of det(a, b, c) = a . (b x c): +1, 0 or -1, exact for finite input. A floating-point filter decides
/// all but nearly coplanar cases, an expansion (Shewchuk 1997, "Adaptive precision floating-point
/// arithmetic") the rest. Each vector is scaled by a power of two first; exactness is lost only where the
/// components of one vector differ by more than a factor of about 2^300. Theorem 1 (signs).
int orientation(const Vec3& a, const Vec3& b, const Vec3& c);

/// Where u lies in the cone over a triangle whose corners have the orientation `side`: +1 inside, 0 on the
/// boundary, -1 outside; 0 for any u if side is 0. Exact.
inline int place_in_cone(const std::array<Vec3, 3>& corners, int side, const Vec3& u) {
  int place = 1;
  for (std::size_t k = 0; k < 3 && place >= 0; ++k)
    place = std::min(place, side * orientation(corners[k], corners[(k + 1) % 3], u));
  return place;
}

/// |fl(u . fl(a x b)) - u . (a x b)| <= kPlaneTestError |u| |a| |b|, in any evaluation order: 2 roundings a
/// component of the cross product, 3 in the scalar product, each 2^-53 of sum |u_i| (|a_j b_k| + |a_k b_j|)
/// <= 2 |u| |a| |b|; 10 in all, doubled to cover the second order terms and the rounding of the norms.
inline constexpr double kPlaneTestError = 20.0 * 0x1p-53;

}  // namespace impinge

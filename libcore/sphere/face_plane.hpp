// SPDX-License-Identifier: GPL-3.0-or-later
// The plane n . x = p of a face, with digits that are right however thin the face is.
//
// In doubles n = (b - a) x (c - a) is off by a few roundings of products of |b - a| |c - a|. Of a thin face
// little is left of those: its plane tilts. Along u this costs, beside what a rounding of u costs in any
// case, up to |b - a| |c - a| R / (|n| r) times as much, R the farthest point of the face and r the nearest.
// Above kMostTilt normal and offset are exact sums instead, each rounded once.
#pragma once

#include <algorithm>
#include <cmath>

#include "sphere/orientation.hpp"
#include "sphere/plane_radius.hpp"

namespace impinge {

/// Of a face in the centre frame, mm.
struct FacePlane {
  Vec3 normal;         // n = (b - a) x (c - a), away from the centre; zero where that is in the plane
  double offset;       // p = n . a
  double size;         // what the roundings of n are a share of: |b - a| |c - a|, or |n| if it is exact
  bool exact = false;  // but for one rounding of p and of each component of n
};

/// Almost no face of a scanned hip is above it, and none whose corners have angles above 15 degrees, if it is
/// small for its distance. The error that tests allow follows from it (stress/measure.hpp).
inline constexpr double kMostTilt = 4.0;

/// From exact sums (sphere/expansion.hpp): for lengths of mesh/lengths.hpp. side = orientation(a, b, c), not
/// 0.
FacePlane exact_face_plane(const Vec3& a, const Vec3& b, const Vec3& c, int side);

/// side = orientation(a, b, c); the offset may be rounding noise of either sign if the face is seen edge-on.
inline FacePlane face_plane(const Vec3& a, const Vec3& b, const Vec3& c, int side) {
  const Vec3 normal = face_normal<double>(a, b, c, side);
  const double ab = (b - a).norm();
  const double ac = (c - a).norm();
  FacePlane plane{normal, normal.dot(a), ab * ac};
  const double tilt = plane.size * std::sqrt(std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()}));
  if (side == 0 || tilt <= kMostTilt * plane.offset) return plane;  // no point is nearer than the plane, nor
  const double nearest = a.norm() - std::max(ab, ac);               // than this
  return tilt <= kMostTilt * normal.norm() * nearest ? plane : exact_face_plane(a, b, c, side);
}

}  // namespace impinge

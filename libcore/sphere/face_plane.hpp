// SPDX-License-Identifier: GPL-3.0-or-later
// The plane n . x = p of a face, with accurate digits however thin the face is.
//
// In doubles n = (b - a) x (c - a) is off by a few roundings of |b - a| |c - a|. For a thin face |n| is much
// smaller, so that the plane tilts. The radius along u is then off by up to t = |b - a| |c - a| R / (|n| r)
// times what a rounding of u costs in any case; R and r are the farthest and the nearest distance of the face
// from the centre. Where t is above kMostTilt, normal and offset are exact sums instead, each rounded once.
#pragma once

#include <algorithm>
#include <cmath>

#include "sphere/orientation.hpp"
#include "sphere/plane_radius.hpp"

namespace impinge {

/// The plane n . x = p of a face in the centre frame, mm.
struct FacePlane {
  Vec3 normal;         // n = (b - a) x (c - a), away from the centre; zero if the centre is in the plane
  double offset;       // p = n . a
  double size;         // n is off by a few roundings of this: |b - a| |c - a|, or |n| if exact
  bool exact = false;  // p and each component of n are exact sums, rounded once
};

/// The largest t that is accepted. Almost no face of a scanned hip is above it, and no face with angles above
/// 15 degrees that is small for its distance. The error that tests allow follows from it
/// (stress/measure.hpp).
inline constexpr double kMostTilt = 4.0;

/// The plane of the face a, b, c by exact sums (sphere/expansion.hpp), for lengths that mesh/lengths.hpp
/// allows. `side` is orientation(a, b, c), not 0.
FacePlane exact_face_plane(const Vec3& a, const Vec3& b, const Vec3& c, int side);

/// The plane of the face a, b, c. `side` is orientation(a, b, c). If the face is seen edge-on, the offset may
/// be rounding noise of either sign.
inline FacePlane face_plane(const Vec3& a, const Vec3& b, const Vec3& c, int side) {
  const Vec3 normal = face_normal<double>(a, b, c, side);
  const double ab = (b - a).norm();
  const double ac = (c - a).norm();
  FacePlane plane{normal, normal.dot(a), ab * ac};
  const double tilt = plane.size * std::sqrt(std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()}));
  if (side == 0 || tilt <= kMostTilt * plane.offset) return plane;  // with the plane's distance for r
  const double nearest = a.norm() - std::max(ab, ac);               // no point of the face is nearer
  return tilt <= kMostTilt * normal.norm() * nearest ? plane : exact_face_plane(a, b, c, side);
}

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// The plane of a face as the centre sees it, and the part of it that a small cap of directions sees.
#pragma once

#include <array>

#include "sphere/triangle_cone.hpp"
#include "table/face_cap.hpp"

namespace impinge {

/// The roundings of a face. With u = 2^-53, d and e two sides of it in double, R its farthest corner, `size`
/// as in FacePlane (sphere/face_plane.hpp) and the condition k = size R / p >= 1, the errors are
///   n = d x e      a component is off by 4 u (|d_j e_k| + |d_k e_j|), all by 4 sqrt(2) u |d| |e| < 6 u size
///   n . x          for unit x, 3 u size more: with p / R the least n . x, by 9 u k of itself
///   p = n . v      likewise
///   r = p / (n.x)  18 u k, one rounding, and 2 u for the length of x: 21 u k
///   p / |n|        9 u k + 6 u k + 3 u; q = n / p as much; the direction of n turns by 6 u k radians
///   tan psi        = |n x v| / (n . v): 11 u k + 9 u k tan psi
/// All are at most kPlaneRoundings k: of the value, in radians, and of 1 + tan psi for tan psi.
inline constexpr double kPlaneRoundings = 32.0 * 0x1p-53;

/// The plane q . x = 1 of a face as the centre sees it: r(u) = 1 / (q . u) along unit u.
struct SurfacePlane {
  TriangleCone cone;             // the face itself
  Vec3 inverse = Vec3::Zero();   // q, 1/mm
  double distance = 0.0;         // of the plane from the centre, 1 / |q|, mm
  double slope = 0.0;            // largest tan psi over the face; infinite for a face that is seen edge-on
  double least_radius = 0.0;     // over the face, mm
  double largest_radius = 0.0;   // over the face, mm
  double doubt = 0.0;            // kPlaneRoundings k, see above; infinite for a face that is seen edge-on
  std::array<Vec3, 3> inward{};  // edge_normal() of each side, to the inside
  Vec3 middle = Vec3::Zero();    // a direction inside
  double chord = 0.0;            // longest from `middle` to a direction of the face
};

/// Unit normal of the plane through the centre and an edge, off by less than kDirectionSlack / 2; zero if the
/// edge is seen as a point, or so nearly that the error would be larger. The difference of the ends is off by
/// u of itself at most, so that short edges lose no digits: the cross product is off by 8 u |from| |to -
/// from| at most.
Vec3 edge_normal(const Vec3& from, const Vec3& to);

SurfacePlane surface_plane(const TriangleCone& cone);  // the plane of the face of this cone

/// Is one face beyond an edge of the other, by more than rounding? Also true if a face is seen edge-on.
bool clearly_apart(const SurfacePlane& a, const SurfacePlane& b);

/// Least and largest radius of a face within a cap, and its largest tan psi there, widened for rounding.
/// The slope is infinite where the cap may see the plane edge-on.
struct PlaneRange {
  double least;    // mm
  double largest;  // mm
  double slope;    // tan psi
};
/// The range over the part of the plane that the cap sees, or over the face if that is less.
PlaneRange range_within(const SurfacePlane& plane, const DirectionCap& cap);

}  // namespace impinge

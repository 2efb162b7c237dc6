// SPDX-License-Identifier: GPL-3.0-or-later
// A face of a surface as the plane that the centre sees, and what a small cap of directions sees of it.
#pragma once

#include <array>

#include "sphere/triangle_cone.hpp"
#include "table/face_cap.hpp"

namespace impinge {

/// What rounding makes of a face. With u = 2^-53, d and e two sides of it in double, R its farthest corner,
/// `size` as in FacePlane (sphere/face_plane.hpp) and the condition k = size R / p >= 1,
///   n = d x e      a component is off by 4 u (|d_j e_k| + |d_k e_j|), all by 4 sqrt(2) u |d| |e| < 6 u size
///   n . x          for unit x, 3 u size more: with p / R the least n . x, by 9 u k of itself
///   p = n . v      likewise
///   r = p / (n.x)  18 u k, one rounding, and 2 u for the length of x: 21 u k
///   p / |n|        9 u k + 6 u k + 3 u; q = n / p as much; the direction of n turns by 6 u k radians
///   tan psi        = |n x v| / (n . v): 11 u k + 9 u k tan psi
/// all of them at most this share of k: of the value, in radians, and of 1 + tan psi for tan psi.
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

/// Unit normal of the plane through the centre and an edge, off by less than kDirectionSlack / 2; zero where
/// the edge is seen so nearly as a point that it is not. The difference of two ends is exact, or off by u of
/// itself, so that short edges lose nothing: by 8 u |from| |to - from| at the most.
Vec3 edge_normal(const Vec3& from, const Vec3& to);

SurfacePlane surface_plane(const TriangleCone& cone);  // of that face

/// Is one face beyond an edge of the other, by more than rounding? Faces that are seen edge-on overlap none.
bool clearly_apart(const SurfacePlane& a, const SurfacePlane& b);

/// Least and largest radius of a face within a cap, and its largest tan psi there, widened for rounding.
/// The slope is infinite where the cap may see the plane edge-on.
struct PlaneRange {
  double least;    // mm
  double largest;  // mm
  double slope;    // tan psi
};
/// Of the part of the plane that the cap sees, or of the face where that is less.
PlaneRange range_within(const SurfacePlane& plane, const DirectionCap& cap);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// A face of a surface as the plane that the centre sees, and what a small cap of directions sees of it.
#pragma once

#include <array>

#include "sampling/direction_cap.hpp"
#include "sphere/triangle_cone.hpp"

namespace impinge {

// The plane q . x = 1 of a face as the centre sees it: r(u) = 1 / (q . u) along unit u.
struct SurfacePlane {
  TriangleCone cone;             // the face itself
  Vec3 inverse = Vec3::Zero();   // q, 1/mm
  double distance = 0.0;         // of the plane from the centre, 1 / |q|, mm
  double slope = 0.0;            // largest tan psi over the face; infinite for a face that is seen edge-on
  double least_radius = 0.0;     // over the face, mm
  double largest_radius = 0.0;   // over the face, mm
  double condition = 0.0;        // relative error of r that one rounding of the plane makes
  std::array<Vec3, 3> inward{};  // unit normals of the planes through the centre and an edge
  Vec3 middle = Vec3::Zero();    // a direction inside
  double chord = 0.0;            // longest from there to a direction of the face
};

SurfacePlane surface_plane(const TriangleCone& cone);  // of that face

// Is one face beyond an edge of the other, by more than rounding? Faces that are seen edge-on overlap none.
bool clearly_apart(const SurfacePlane& a, const SurfacePlane& b);

// Largest and least radius of a plane within a cap and the face's own limits, mm, and its largest tan psi
// there. infinite slope where the cap may see the plane edge-on.
struct PlaneRange {
  double least;    // mm
  double largest;  // mm
  double slope;    // tan psi
};
// Of the part of the plane that the cap sees, or of the face where that is less.
PlaneRange range_within(const SurfacePlane& plane, const DirectionCap& cap);

}  // namespace impinge

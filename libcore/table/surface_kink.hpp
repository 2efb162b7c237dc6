// SPDX-License-Identifier: GPL-3.0-or-later
// An edge of a surface at which its inverse radius has a hinge.
#pragma once

#include <optional>

#include "table/face_cap.hpp"

namespace impinge {

/// An edge of two or more faces: the inverse radius q . u is continuous across it, and q
/// jumps. Only edges between faces that lie on opposite sides of it; the others are jump edges (rim.hpp).
struct SurfaceKink {
  Vec3 across;          // its edge_normal() (surface_plane.hpp), which may be zero
  Vec3 from;            // unit vectors to its ends
  Vec3 to;              // unit vector to the other end
  Vec3 jump;            // difference of q, 1/mm
  double least_radius;  // along the edge, mm
  double largest_radius;
};

/// Of an edge between two points, mm; none where the centre sees it as a point.
std::optional<SurfaceKink> surface_kink(const Vec3& from, const Vec3& to, const Vec3& jump);

/// May the edge meet the cap?
bool meets(const SurfaceKink& kink, const DirectionCap& cap);

}  // namespace impinge

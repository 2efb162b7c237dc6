// SPDX-License-Identifier: GPL-3.0-or-later
// An edge of a surface at which its inverse radius has a hinge.
#pragma once

#include <optional>

#include "table/face_cap.hpp"

namespace impinge {

/// An edge across which the inverse radius q . u is continuous and q jumps: one between faces that lie on
/// opposite sides of it. Other edges are jump edges (rim.hpp).
struct SurfaceKink {
  Vec3 across;          // its edge_normal() (surface_plane.hpp), which may be zero
  Vec3 from;            // unit vector to one end
  Vec3 to;              // unit vector to the other end
  Vec3 jump;            // difference of q, 1/mm
  double least_radius;  // along the edge, mm
  double largest_radius;
};

/// The kink at an edge between two points, mm; std::nullopt if the centre sees the edge as a point.
std::optional<SurfaceKink> surface_kink(const Vec3& from, const Vec3& to, const Vec3& jump);

/// May the edge meet the cap?
bool meets(const SurfaceKink& kink, const DirectionCap& cap);

}  // namespace impinge

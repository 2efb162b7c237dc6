// SPDX-License-Identifier: GPL-3.0-or-later
// A vertex turns about an axis and touches the face of an octahedron at a grazing angle: the motion of the
// family `stiff_motion`. Lengths in mm, angles in radians.
#pragma once

#include <array>
#include <optional>

#include "methods/points.hpp"
#include "sphere/direction.hpp"
#include "stress/precise.hpp"

namespace impinge::lab {

// The path of the vertex: along + cos(angle) aside + sin(angle) (axis x aside).
struct Slide {
  Vec3 axis;   // unit vector
  Vec3 along;  // mm, the part of the vertex along the axis
  Vec3 aside;  // mm, the part across it at angle 0

  Vec3 vertex(double angle) const;  // mm
};

// A slide about an axis 60 degrees from the normal of the face x, y, z > 0 of an octahedron of this radius.
// The vertex is 40 degrees from the axis. At angle 0 it is nearest to the face, 20 degrees from the normal;
// at the angle `contact` it is on the face, to rounding.
Slide slide_touching_at(double contact, double octahedron_radius);

// The slide in 200 bits, from its doubles.
class PreciseSlide {
 public:
  PreciseSlide(const Slide& slide, double octahedron_radius);  // octahedron_radius as in slide_touching_at()

  // Gap of the vertex from the face, along its ray.
  Precise gap(const Precise& angle) const;
  // The angle before 0 at which the gap vanishes.
  Precise contact() const;

 private:
  Precise radius_;
  std::array<Precise, 3> along_;
  std::array<Precise, 3> aside_;
  std::array<Precise, 3> ahead_;
};

// The first angle from `start` to 0 at which the method sees no gap, by bisection down to neighbouring
// doubles. None if it sees no gap at the start, or a gap at 0.
std::optional<double> touching_angle(const PointQuery& query, const Slide& slide, double start);

}  // namespace impinge::lab

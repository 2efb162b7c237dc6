// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces with a formula, to measure errors against: the radius along a direction and how steep it is there.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "sphere/conchoid_shape.hpp"
#include "sphere/direction.hpp"

namespace impinge::lab {

// Directions are unit vectors. The formulas hold a little beyond the opening too, where a stencil may reach.
struct RadialSurface {
  std::string name;                           // in tables of results
  std::function<double(const Vec3&)> radius;  // mm
  std::function<double(const Vec3&)> slope;   // tan psi = |grad r| / r, psi from the direction to the normal
  Vec3 axis = Vec3::UnitZ();                  // unit vector, the middle of what is examined
  double opening = kPi;                       // radians about the axis within which the surface is examined

  // Is the surface examined along u?
  bool covers(const Vec3& u) const { return opening >= kPi || angle_between(axis, u) <= opening; }
};

// Sphere about `centre`, |centre| < radius; both mm.
RadialSurface spherical_surface(std::string name, double radius, const Vec3& centre);

// Menschik's conchoid r = a + b cos(phi), 0 <= b < a (mm), turned about its axis (unit vector) and examined
// up to phi = 90 degrees, as in the thesis (Eq. 11-14).
RadialSurface conchoid_surface(std::string name, const ConchoidShape& shape, const Vec3& axis);

// The plane n.x = p (n a unit vector, p > 0 mm), examined up to an incidence of `steepest_deg` < 90 degrees.
RadialSurface planar_surface(std::string name, const Vec3& normal, double distance, double steepest_deg);

// A convex edge: the nearer of two planes that meet, at distance `radius` (mm) along the unit vector `axis`,
// in the line along the unit vector `edge` across it. Their normals are `dihedral_deg` apart, turned by half
// of it to either side of a mean normal that makes `tilt_deg` with the axis about the edge.
struct EdgeShape {
  Vec3 axis = Vec3::UnitX();  // towards the middle of the edge
  Vec3 edge = Vec3::UnitZ();  // along the edge
  double radius = 22.0;       // mm, from the centre to the edge along the axis
  double dihedral_deg = 2.0;  // between the normals
  double tilt_deg = 0.0;      // of the mean normal against the axis
  double opening_deg = 30.0;  // examined within this of the axis
};
// An edge, and the planes that meet there.
struct EdgeSurface {
  RadialSurface surface;  // the nearer of the two planes
  Vec3 inverse_1;         // n / p of the plane to one side, 1/mm
  Vec3 inverse_2;         // to the other side
};
// The edge of that shape. std::invalid_argument where it is not convex or not across its axis, or a plane is
// seen at 90 degrees or more.
EdgeSurface edge_surface(std::string name, const EdgeShape& shape);

// Directions spread over the strip within `half_width` radians of that edge and the opening of its surface.
std::vector<Vec3> directions_along(const EdgeShape& shape, double half_width, std::size_t count);

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// Generated bodies with known answers. Lengths in millimetres, normals outward (cup: towards the centre).
// "Mesh radius" is the distance from the origin to the faces, "radius" the distance to the smooth surface
// which they approximate. All functions throw std::invalid_argument, one line, for sizes that give no such
// body.
#pragma once

#include <cstddef>
#include <functional>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Sphere about `centre` with exactly `faces` faces: even, 8 or more. Vertices on the sphere, see rings.hpp.
TriangleMesh sphere(double radius, std::size_t faces, const Vec3& centre = Vec3::Zero());

/// Distance from the origin to this sphere along a direction, for |centre| < radius:
///   r(u) = e.u + sqrt(R^2 - |e|^2 + (e.u)^2),  e the centre, R the radius.
double eccentric_sphere_radius(const Vec3& direction, double radius, const Vec3& centre);

/// Closed body whose vertices are at the distance radius(u) from the origin, along the directions u of the
/// vertices of a unit sphere.
TriangleMesh radial_body(std::size_t faces, const std::function<double(const Vec3&)>& radius);

/// Octahedron with its corners on the axes at the distance `radius`.
TriangleMesh octahedron(double radius);
double octahedron_mesh_radius(const Vec3& direction, double radius);  // its mesh radius, R / |u|_1, mm

/// Pyramid over a regular polygon, apex on +z, base plane z = -base_depth; the origin lies inside. 2 * sides
/// faces: vertex 0 is the apex, 1 the middle of the base, base corner k at azimuth 2 pi k / sides.
struct ConeShape {
  double base_radius = 20.0;  // mm, from the axis to a base corner
  double apex_height = 30.0;  // mm above the origin
  double base_depth = 10.0;   // mm below the origin
  std::size_t sides = 64;     // 3 or more
};
TriangleMesh cone(const ConeShape& shape = {});  // the pyramid, which is a cone for many sides

/// Mesh radius of the cone: the nearest of its planes ahead, min of d / (n.u) over n.u > 0.
double cone_mesh_radius(const Vec3& direction, const ConeShape& shape = {});

/// Open spherical cap about the origin with its pole on +z and its rim at half_opening_deg (degrees, in (0,
/// 180)) from the pole. Its normals point to the centre, as in a socket. Exactly `faces` faces, 3 or
/// more.
TriangleMesh cup(double inner_radius, double half_opening_deg, std::size_t faces);

}  // namespace impinge

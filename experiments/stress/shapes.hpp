// SPDX-License-Identifier: GPL-3.0-or-later
// The shapes that families of cases are made of, centre frame, mm. Each is defined beside the family that it
// is for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "sphere/direction.hpp"
#include "stress/methods.hpp"

namespace impinge::lab {

// A face that the direction meets at kAimedRadius, its plane `beside` radians from holding the direction.
TriangleMesh near_tangent_face(const Vec3& aim, double beside);

// A wall of that kind about the direction, of so many faces, as far as wall_reach(beside) radians from it.
inline constexpr std::size_t kWallSides = 6;
double wall_reach(double beside);
TriangleMesh near_tangent_wall(const Vec3& aim, double beside);

// Four faces round a point of the direction, which is inside of the first: a sliver, `aspect` times as high
// as it is long.
TriangleMesh aimed_sliver(const Vec3& aim, double aspect);

// A mesh with a sliver along one side of every face (and, for aspect 0, a face between two corners at one
// place and a third), and the directions through the middles of the slivers.
StabilityScene slivered(const TriangleMesh& mesh, double aspect);

// A closed body whose coordinates are multiples of 1/64 mm, so that sums of two or three are exact.
TriangleMesh dyadic_body();

// The vector with each component in its turn moved by so many units in the last place, up and down: 6
// vectors; the vector itself alone for none.
std::vector<Vec3> ulps_beside(const Vec3& x, int ulps);

// A strip that is pleated `layers` deep, turned about an axis: each layer reaches from 25 to 65 degrees of
// it, 1 mm above the one before, and hangs together with it at one end.
TriangleMesh pleated(std::size_t layers);

// A mesh of which `share` of the faces were taken out, as many turned over, and as many put in twice.
TriangleMesh noisy(const TriangleMesh& mesh, double share, std::uint64_t seed);

// Faces built so that a given direction meets them where they are hard to meet.

inline constexpr double kAimedRadius = 20.0;  // mm, of the point of a face that is aimed at

// A right-handed frame about a direction: u, first and second are orthonormal.
struct AimedFrame {
  explicit AimedFrame(const Vec3& direction);  // direction: of any length above zero
  Vec3 u;                                      // the direction
  Vec3 first;                                  // across it
  Vec3 second;                                 // u x first
};

// Every one to `each` entries of every scheme at a precision, evenly through its table; directions that
// several schemes share come once. Tables meet what is aimed at them at an entry.
std::vector<Vec3> aimed_entries(double precision_deg, std::size_t each);

// Puts the corners and faces of one mesh behind those of another.
void append(TriangleMesh& mesh, const TriangleMesh& more);

// A sphere of 45 mm about the origin, of 300 faces: what lies behind aimed faces.
TriangleMesh backdrop();

}  // namespace impinge::lab

// SPDX-License-Identifier: GPL-3.0-or-later
// The shapes of the cases, centre frame, mm. Each is defined in the file of its family.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "sphere/direction.hpp"
#include "stress/methods.hpp"

namespace impinge::lab {

// A face that the direction meets at kAimedRadius; its plane is `beside` radians from holding the direction.
TriangleMesh near_tangent_face(const Vec3& aim, double beside);

// A wall of such faces about the direction, as far as wall_reach(beside) radians from it.
inline constexpr std::size_t kWallSides = 6;
double wall_reach(double beside);
TriangleMesh near_tangent_wall(const Vec3& aim, double beside);

// Four faces round a point of the direction. The point is inside the first face, a sliver that is `aspect`
// times as high as it is long.
TriangleMesh aimed_sliver(const Vec3& aim, double aspect);

// A mesh with a sliver along one side of every face, and the directions through the middles of the slivers.
// For aspect 0 there is also a face with two corners at one place.
StabilityScene slivered(const TriangleMesh& mesh, double aspect);

// A closed body with coordinates that are multiples of 1/64 mm, so that sums of two or three are exact.
TriangleMesh dyadic_body();

// Six vectors: each component in turn moved by so many units in the last place, up and down. For 0 units only
// the vector itself.
std::vector<Vec3> ulps_beside(const Vec3& x, int ulps);

// A strip with `layers` pleats, turned about an axis. Each layer reaches from 25 to 65 degrees from the axis,
// 1 mm above the one before, and is joined to it at one end.
TriangleMesh pleated(std::size_t layers);

// A mesh with `share` of the faces removed, as many turned over, and as many repeated.
TriangleMesh noisy(const TriangleMesh& mesh, double share, std::uint64_t seed);

// Faces that a given direction meets where they are hard to meet.

inline constexpr double kAimedRadius = 20.0;  // mm, of the point at which a face is aimed

// A right-handed frame about a direction: u, first and second are orthonormal.
struct AimedFrame {
  explicit AimedFrame(const Vec3& direction);  // direction: of any length above zero
  Vec3 u;                                      // the direction
  Vec3 first;                                  // across it
  Vec3 second;                                 // u x first
};

// Every one of `each` entries of every scheme at a precision, evenly spread over its table; directions shared
// by several schemes come once. Tables meet at an entry what is aimed at it.
std::vector<Vec3> aimed_entries(double precision_deg, std::size_t each);

// Appends the corners and faces of one mesh to another.
void append(TriangleMesh& mesh, const TriangleMesh& more);

// A sphere of 45 mm about the origin with 300 faces, which lies behind aimed faces.
TriangleMesh backdrop();

}  // namespace impinge::lab

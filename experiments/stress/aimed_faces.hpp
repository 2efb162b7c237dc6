// SPDX-License-Identifier: GPL-3.0-or-later
// Faces built so that a given direction meets them where they are hard to meet.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "sphere/direction.hpp"

namespace impinge::lab {

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

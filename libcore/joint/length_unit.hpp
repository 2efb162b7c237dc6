// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files do not say their unit of length. A mesh in metres beside one in millimetres, or two in metres,
// are known by their size.
#pragma once

#include <string>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

// Distances of the corners of a surface from the centre of rotation, mm.
struct Reach {
  double nearest = 0.0;   // the least of them
  double farthest = 0.0;  // the largest of them
};

// Of a mesh in the centre frame that has faces.
Reach reach_of(const TriangleMesh& mesh);

// Empty where the two can face each other in a joint; otherwise what is wrong, and what to do: all of one
// surface is more than five times as far from the centre as all of the other.
std::string different_units(const Reach& ball, const Reach& socket);

// Empty where a joint can have this size in mm: a reach of 0.1 mm (the hip of a mouse has 0.6) to 1 m (a
// whole femur has 0.45). Otherwise what to look at.
std::string doubtful_unit(const Reach& ball);

}  // namespace impinge

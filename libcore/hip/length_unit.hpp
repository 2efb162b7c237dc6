// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files do not say their unit of length. A mesh in metres or centimetres beside one in millimetres, or
// two of them, are known by their size.
#pragma once

#include <string>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Distances of the corners of a surface from the centre of rotation, mm.
struct Reach {
  double nearest = 0.0;   // the least of them
  double farthest = 0.0;  // the largest of them
};

/// Of a mesh in the centre frame that has faces.
Reach reach_of(const TriangleMesh& mesh);

/// Empty where the two can face each other in a joint; otherwise what is wrong, and what to do: all of one
/// surface is more than five times as far from the centre as all of the other, or one is so in most of the
/// directions that both cover: the ratio of Facing (arrangement.hpp), NaN where that is not known.
std::string different_units(const Reach& ball, const Reach& socket, double ratio);

/// Empty where a human ball has this radius in mm: 5 (a newborn's has 8) to 50. Otherwise what to look at: in
/// centimetres it has 2 to 3, and so it has in mm in a rat.
std::string doubtful_unit(double ball_radius);

}  // namespace impinge

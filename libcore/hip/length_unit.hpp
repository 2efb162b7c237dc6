// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files do not say their unit of length. Metres or centimetres, in one mesh or in both, are recognised
// by the size of the meshes.
#pragma once

#include <string>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Distances of the corners of a surface from the centre of rotation, mm.
struct Reach {
  double nearest = 0.0;   // the least of them
  double farthest = 0.0;  // the largest of them
};

/// Reach of the face corners of a mesh, which is in the centre frame and has faces.
Reach reach_of(const TriangleMesh& mesh);

/// Empty if the two may be in one unit; otherwise what is wrong and what to do. They are not in one unit if
/// every corner of one is more than five times as far from the centre as every corner of the other, or if the
/// median `ratio` of radii (Facing::ratio in arrangement.hpp; NaN if unknown) is above 5 or below 1/5.
std::string different_units(const Reach& ball, const Reach& socket, double ratio);

/// Empty if some joint may have this radius in mm: 0.1 to 1000. Metres of a hip are below it, down to a
/// shrew's head of 0.25 mm and up to the largest dinosaur's no animal is beyond it. Otherwise what is wrong
/// and what to do.
std::string wrong_unit(double ball_radius);

/// Empty if a human ball may have this radius in mm: 5 (a newborn's has 8) to 50. Otherwise what to check: a
/// radius of 2 to 3 may be a human ball in centimetres, or a rat's in mm.
std::string doubtful_unit(double ball_radius);

}  // namespace impinge

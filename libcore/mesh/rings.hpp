// SPDX-License-Identifier: GPL-3.0-or-later
// Nearly equilateral triangulations of the unit sphere and of a spherical cap: a pole, rings of equally
// spaced points on parallels, and stitched bands between them. Unlike subdivided icosahedra they exist at any
// size.
//
// A closed sphere with rings of n_1..n_m points has 2 (n_1 + ... + n_m) faces, a cap whose rim is ring m has
// 2 (n_1 + ... + n_{m-1}) + n_m. So a sphere can have every even number of faces, a cap every number.
#pragma once

#include <cstddef>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Closed unit sphere about the origin, outward normals, vertex 0 at +z and the last one at -z. The vertices
/// lie on the sphere, the faces within it. Throws std::invalid_argument unless `faces` is even and at
/// least 8.
TriangleMesh unit_sphere(std::size_t faces);

/// The part of the unit sphere within half_opening (radians, in (0, pi)) of +z: vertex 0 at +z, the last ring
/// is the rim. Outward normals. Throws std::invalid_argument for fewer than 3 faces or another half_opening.
TriangleMesh unit_cap(std::size_t faces, double half_opening);

}  // namespace impinge

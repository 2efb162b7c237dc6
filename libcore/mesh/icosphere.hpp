// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A sphere of nearly equal triangles: an icosahedron whose edges are halved repeatedly, the new corners
/// moved out to the sphere.
#pragma once

#include <cstddef>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Closed sphere about the origin, normals outward, with 20 * 4^halvings faces and its corners at `radius`
/// mm, one on each pole. Throws std::invalid_argument unless the radius is a positive length, and for more
/// than 8 halvings (1.3 million faces).
TriangleMesh icosphere(double radius, std::size_t halvings);

}  // namespace impinge

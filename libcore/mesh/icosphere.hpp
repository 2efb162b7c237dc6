// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A sphere of nearly equal triangles: an icosahedron whose edges are halved repeatedly, the new corners
/// moved out to the sphere.
#pragma once

#include <cstddef>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Closed sphere about the origin, normals outward, 20 * 4^halvings faces, corners at `radius` mm, one of
/// them on either pole. Throws std::invalid_argument for a radius that is no positive length and for more
/// than 8 halvings (1.3 million faces).
TriangleMesh icosphere(double radius, std::size_t halvings);

}  // namespace impinge

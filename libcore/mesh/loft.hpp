// SPDX-License-Identifier: GPL-3.0-or-later
// A surface through rings of points.
#pragma once

#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Joins each ring with the next by a band of triangles, at each step with the shorter of the two possible
/// diagonals. The points of a ring must go counter-clockwise as seen from outside, from beyond the first
/// ring, and all rings start at about the same place. A ring of one point is a pole: as first or last ring it
/// closes the surface, which is open otherwise. Normals point outward. Vertices are the points in their
/// order. Throws std::invalid_argument for fewer than two rings, a ring of two points or none, or two poles
/// in a row.
TriangleMesh loft(std::span<const std::vector<Vec3>> rings);

}  // namespace impinge

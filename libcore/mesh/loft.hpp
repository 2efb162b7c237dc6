// SPDX-License-Identifier: GPL-3.0-or-later
// A surface through rings of points.
#pragma once

#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Joins each ring with the next by a band of triangles, at each step the shorter of the two possible
/// diagonals. Points of a ring go counter-clockwise as seen from outside beyond the first ring, and all rings
/// start at about the same place. A ring of one point is a pole: first or last it closes the surface, where
/// it is open otherwise. Normals point outward. Vertices are the points in their order. std::invalid_argument
/// for fewer than two rings, a ring of two points or none, or two poles in a row.
TriangleMesh loft(std::span<const std::vector<Vec3>> rings);

}  // namespace impinge

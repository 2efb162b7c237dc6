// SPDX-License-Identifier: GPL-3.0-or-later
// Directions along which the error of a table is measured.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "sphere/uniform_directions.hpp"

namespace impinge {

/// Directions spread evenly over the two caps within `within` radians of the poles: `count` in all.
std::vector<Vec3> polar_directions(double within, std::size_t count);

/// Directions through every vertex and through the middle of every edge of a mesh in the centre frame, where
/// the radius of the mesh has its kinks.
std::vector<Vec3> feature_directions(const TriangleMesh& mesh);

}  // namespace impinge

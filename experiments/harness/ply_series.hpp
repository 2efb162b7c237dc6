// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh with a number a vertex for each of many states of a joint, as along a motion: one file, not one a
// state.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// One state: `values` has one number a vertex, NaN where there is none.
struct VertexSeries {
  std::string property;       // its name in the file
  std::vector<float> values;  // by vertex
};

// Binary little-endian PLY, atomically: x y z as float in mm, then the states in their order as float, faces
// as list uchar int vertex_indices. std::invalid_argument where a state has another number of values than the
// mesh has vertices or a name that is empty, has blanks or comes twice; FileError where the file cannot be
// written.
void write_ply_series(const std::filesystem::path& file, const TriangleMesh& mesh,
                      std::span<const VertexSeries> states);

}  // namespace impinge::lab

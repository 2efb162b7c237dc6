// SPDX-License-Identifier: GPL-3.0-or-later
// One file for a mesh and many states of a joint, as along a motion, each with one number a vertex.
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
// as list uchar int vertex_indices. std::invalid_argument unless each state has one value for each vertex and
// a name of its own that is not empty and has no blanks; FileError if the file cannot be written.
void write_ply_series(const std::filesystem::path& file, const TriangleMesh& mesh,
                      std::span<const VertexSeries> states);

}  // namespace impinge::lab

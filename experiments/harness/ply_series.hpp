// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a mesh and many states of a joint, such as a motion, to one file: a number per vertex and state.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// One state; NaN where a vertex has no value.
struct VertexSeries {
  std::string property;       // its name in the file
  std::vector<float> values;  // by vertex
};

// Writes binary little-endian PLY, atomically: x y z as float in mm, then the states in their order as float;
// faces as list uchar int vertex_indices. Throws std::invalid_argument unless each state has one value per
// vertex and a different name without blanks; FileError if the file cannot be written.
void write_ply_series(const std::filesystem::path& file, const TriangleMesh& mesh,
                      std::span<const VertexSeries> states);

}  // namespace impinge::lab

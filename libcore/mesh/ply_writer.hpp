// SPDX-License-Identifier: GPL-3.0-or-later
// Binary PLY, and what it and other mesh files say beside points and faces.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

using Rgb = std::array<std::uint8_t, 3>;  // red, green and blue, 0 to 255

/// A number of each vertex; NaN values (say: no gap here) stay NaN.
struct VertexValues {
  std::string_view name;           // without blanks
  std::span<const double> values;  // in the order of the vertices
};

/// What is only viewed must outlive it.
struct MeshNotes {
  std::string_view axes{};             // RAS or LPS, which files then say; nothing is said of another code
  std::vector<VertexValues> values{};  // for viewers the first is the main one
  std::vector<Rgb> colours{};          // of each vertex, or none
};

/// "SPACE=RAS" or "SPACE=LPS", as 3D Slicer reads it, or nothing.
std::string space_of(const MeshNotes& notes);

/// std::invalid_argument unless there are as many values and colours as vertices, if a name is empty, has
/// blanks or is one of those below, and if a face names a vertex that is not there.
void check_notes(const TriangleMesh& mesh, const MeshNotes& notes);

/// Little-endian: x y z as double in mm, faces as list uchar int vertex_indices; colours, and of the values
/// the first alone, as double under its name. Throws as check_notes().
///
/// Viewers disagree on where a scalar belongs, so the value is also written as
/// * quality (float): what MeshLab reads as the vertex quality, to be mapped to colours there;
/// * u, v (float, v = 0): VTK 9.1, and with it ParaView and 3D Slicer, ignores properties of other names and
///   offers these two as the point array TCoords, whose first component is the value;
/// * red, green, blue (uchar), the colours: all three viewers show them at once, VTK as point array RGB.
std::string ply_bytes(const TriangleMesh& mesh, const MeshNotes& notes = {});

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Writes binary PLY; and describes what mesh files say beside points and faces.
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

/// A number for each vertex; NaN (such as no gap here) stays NaN.
struct VertexValues {
  std::string_view name;           // without blanks
  std::span<const double> values;  // in the order of the vertices
};

/// What a mesh file says beside points and faces. The memory that the views point to must outlive it.
struct MeshNotes {
  std::string_view axes{};             // RAS or LPS, which files then say; any other code is not said
  std::vector<VertexValues> values{};  // the first is the main one for viewers
  std::vector<Rgb> colours{};          // one for each vertex, or empty
};

/// "SPACE=RAS" or "SPACE=LPS", as 3D Slicer reads it, or an empty text.
std::string space_of(const MeshNotes& notes);

/// Throws std::invalid_argument unless there are as many values and colours as vertices, or if a name is
/// empty, has blanks or is one of the names below, or if a face names a vertex that does not exist.
void check_notes(const TriangleMesh& mesh, const MeshNotes& notes);

/// A little-endian PLY file: x y z as double in mm, faces as list uchar int vertex_indices, the colours, and
/// only the first of the values, as double under its name. Throws as check_notes().
///
/// Viewers disagree on where a scalar belongs, so the value is also written as
/// * quality (float): what MeshLab reads as the vertex quality, to be mapped to colours there;
/// * u, v (float, v = 0): VTK 9.1, and with it ParaView and 3D Slicer, ignores properties of other names and
///   offers these two as the point array TCoords, whose first component is the value;
/// * red, green, blue (uchar), the colours: all three viewers show them at once, VTK as point array RGB.
std::string ply_bytes(const TriangleMesh& mesh, const MeshNotes& notes = {});

}  // namespace impinge

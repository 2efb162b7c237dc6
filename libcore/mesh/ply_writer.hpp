// SPDX-License-Identifier: GPL-3.0-or-later
// Binary PLY with a number per vertex, for viewers.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

using Rgb = std::array<std::uint8_t, 3>;  // red, green and blue, 0 to 255

/// Binary little-endian PLY, atomically (see file_bytes.hpp): x y z as double in mm, faces as list uchar int
/// vertex_indices. Throws FileError, also for a mesh with a face that names no vertex.
void write_ply(const std::filesystem::path& file, const TriangleMesh& mesh);

/// The same with one value per vertex under the name `property`, as double, and optionally one colour per
/// vertex. NaN values (say: no gap here) stay NaN. Throws std::invalid_argument unless there are as many
/// values and colours as vertices, and if the name is empty, has blanks or is one of those below.
///
/// Viewers disagree on where a scalar belongs, so the value is also written as
/// * quality (float): what MeshLab reads as the vertex quality, to be mapped to colours there;
/// * u, v (float, v = 0): VTK 9.1, and with it ParaView and 3D Slicer, ignores properties of other names and
///   offers these two as the point array TCoords, whose first component is the value;
/// * red, green, blue (uchar), the colours: all three viewers show them at once, VTK as point array RGB.
void write_ply(const std::filesystem::path& file, const TriangleMesh& mesh, std::string_view property,
               std::span<const double> values, std::span<const Rgb> colours = {});

/// The bytes of that file. A face that names no vertex is std::invalid_argument here.
std::string ply_bytes(const TriangleMesh& mesh, std::string_view property, std::span<const double> values,
                      std::span<const Rgb> colours = {});

}  // namespace impinge

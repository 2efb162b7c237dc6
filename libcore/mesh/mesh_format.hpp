// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh formats that can be read and written.
#pragma once

#include <array>
#include <filesystem>
#include <string_view>

#include "files/fields.hpp"

namespace impinge {

/// The format of a mesh file: Stanford PLY, STL, Wavefront OBJ, Object File Format, or VTK's PolyData as XML
/// or in its legacy format.
enum class MeshFormat { ply, stl, obj, off, vtp, vtk };
/// The file extensions without the point.
template <>
inline constexpr std::array<std::string_view, 6> words_of<MeshFormat>{"ply", "stl", "obj",
                                                                      "off", "vtp", "vtk"};

/// The format that the extension names, in any case. Throws FileError for any other extension.
MeshFormat mesh_format(const std::filesystem::path& file);

}  // namespace impinge

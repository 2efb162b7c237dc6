// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh formats that can be read and written.
#pragma once

#include <filesystem>

namespace impinge {

/// What a mesh file is written in: Stanford PLY, STL, Wavefront OBJ or Object File Format.
enum class MeshFormat { ply, stl, obj, off };

/// The format that the extension names, in any case. Throws FileError for any other extension.
MeshFormat mesh_format(const std::filesystem::path& file);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Reading and writing triangle meshes: PLY, STL, OBJ, OFF, and VTK's PolyData (VTP, legacy VTK). Needs
/// assimp, pugixml and zlib (target impinge::mesh_io).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "files/file_error.hpp"
#include "mesh/ply_writer.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Reads a mesh; the extension (.ply, .stl, .obj, .off, .vtp, .vtk, any case) names the format. Polygons are
/// triangulated, all parts of the file merged, vertices with equal coordinates welded (STL shares none),
/// faces that collapse thereby dropped; nothing else is repaired, see validation.hpp. Vertices keep the order
/// of the file, except those of STL and OBJ, which come in the order of their first use.
///
/// assimp holds coordinates as float32: they are within 6e-8 of the file's, relatively (2e-7 for text), that
/// is within 3e-5 mm (1e-4 mm) for a scan 500 mm from its origin.
///
/// Throws FileError when the file is missing, not a regular file, empty, beyond kMostMeshBytes, not of its
/// format, cut short or damaged (see file_checks.hpp for what that finds), has no faces, has coordinates that
/// are NaN, infinite or beyond the range of a float, or only faces without area.
TriangleMesh read_mesh(const std::filesystem::path& file);

/// The same from bytes in memory. `file` chooses the format and is the name in messages.
TriangleMesh parse_mesh(const std::filesystem::path& file, std::string bytes);

/// Larger files, of some 80 million triangles, are refused before they are read.
inline constexpr std::uintmax_t kMostMeshBytes = std::uintmax_t{4} << 30U;

/// A mesh in the format that the extension names. STL (binary) holds float32, all others doubles. OBJ comes
/// without a material library beside it. Values of the vertices are kept by VTP and VTK, and by PLY as
/// ply_writer.hpp says, colours by PLY alone; all but OFF say RAS or LPS. Throws FileError for an unknown
/// extension, a mesh without faces, with a face that names no vertex or with coordinates that are not finite,
/// and as check_notes() does.
std::string mesh_bytes(const std::filesystem::path& file, const TriangleMesh& mesh,
                       const MeshNotes& notes = {});

/// Writes it under a temporary name, then renamed. FileError also when the file cannot be written.
void write_mesh(const std::filesystem::path& file, const TriangleMesh& mesh, const MeshNotes& notes = {});

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Reads and writes triangle meshes: PLY, STL, OBJ, OFF, and VTK's PolyData (VTP, legacy VTK). Needs assimp,
/// pugixml and zlib (target impinge::mesh_io).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "files/file_error.hpp"
#include "mesh/ply_writer.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Reads a mesh; the extension (.ply, .stl, .obj, .off, .vtp, .vtk, any case) names the format. Polygons are
/// triangulated, all parts of the file merged, vertices with equal coordinates welded (STL shares none), and
/// faces dropped that collapse thereby. Nothing else is repaired, see validation.hpp. Vertices keep the order
/// of the file, except in STL and OBJ, where they come in the order of their first use.
///
/// Coordinates are rounded to float32: they are within 6e-8 of the file's, relatively (2e-7 for text), which
/// is within 3e-5 mm (1e-4 mm) for a scan 500 mm from its origin.
///
/// Throws FileError if the file is missing, not a regular file, empty, beyond kMostMeshBytes, not of its
/// format, cut short or damaged (file_checks.hpp says what is found), or has no faces, coordinates that are
/// NaN, infinite or beyond the range of a float, or only faces without area.
TriangleMesh read_mesh(const std::filesystem::path& file);

/// The same from bytes in memory. `file` chooses the format and is the name in messages.
TriangleMesh parse_mesh(const std::filesystem::path& file, std::string bytes);

/// Larger files, of some 80 million triangles, are refused before they are read.
inline constexpr std::uintmax_t kMostMeshBytes = std::uintmax_t{4} << 30U;

/// The bytes of a mesh file in the format that the extension names. STL (binary) holds float32, all others
/// doubles. OBJ comes without a material library. VTP and VTK keep the values of vertices, PLY as
/// ply_writer.hpp says; only PLY keeps colours; all but OFF say RAS or LPS. Throws FileError for an unknown
/// extension, for a mesh without faces, with a face that names no vertex or with coordinates that are not
/// finite, and as check_notes() does.
std::string mesh_bytes(const std::filesystem::path& file, const TriangleMesh& mesh,
                       const MeshNotes& notes = {});

/// Writes these bytes under a temporary name, then renames the file. Throws as mesh_bytes(), and FileError if
/// the file cannot be written.
void write_mesh(const std::filesystem::path& file, const TriangleMesh& mesh, const MeshNotes& notes = {});

}  // namespace impinge

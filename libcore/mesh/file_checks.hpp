// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that a mesh file is whole, which assimp does not do. Each check goes through all bytes of a file and
// compares the counts in its header with what follows, and every index with the number of vertices, before
// anything is allocated. All checks throw FileError.
//
// Left to itself, assimp 5.2
// * allocates the counts that a header declares (4e9 vertices in a PLY file of 200 bytes: 48 GB);
// * reads a binary PLY cut at any place, with indices far outside of the mesh for the missing faces, and an
//   ascii PLY or OFF with empty faces and vertices at the origin; an ascii STL that is cut makes it leak
//   memory;
// * reads an OBJ file cut at most places, and opens the material library that the file names;
// * in an OFF file turns indices that are out of range into the last vertex, leaves out polygons of more than
//   nine corners, and takes comments for data;
// * reads no faces, or wrong ones, after an element of a PLY file that it does not know, such as a camera;
// * does not read coordinates that begin with a point in an OBJ file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace impinge {

/// Checksums to compare with what a reader has found.
struct MeshFileSums {
  double coordinates = 0.0;  // of the magnitudes of all coordinates
  double corners = 0.0;      // of the indices of all corners of polygons, from 0
};

/// What a reader must find in the file.
struct MeshFileContent {
  std::optional<std::size_t> vertices;  // PLY and OFF
  std::size_t polygons = 0;             // faces of three corners or more
  std::optional<MeshFileSums> sums;     // PLY and OFF
};

// In text formats other than PLY, `bytes` is replaced by the same vertices and faces in their plainest form:
// no comments, names, materials, colours, normals; several ascii STL solids become one. Files of VTK become a
// PLY file: their pieces side by side, strips as triangles, no points and lines.

/// PLY, binary (both byte orders) or ascii. A cut at any byte is found, except within the last number of an
/// ascii file, as a last line without line end is legal.
MeshFileContent check_ply(const std::filesystem::path& file, std::string_view bytes);

/// STL. Binary: 84 + 50 n bytes; anything after them is cut off, unless it could be more triangles. Ascii, in
/// upper or lower case: complete facets, and endsolid at the end.
MeshFileContent check_stl(const std::filesystem::path& file, std::string& bytes);

/// OFF: text with the keyword OFF, COFF, NOFF, CNOFF or STOFF. Cuts are found as in ascii PLY.
MeshFileContent check_off(const std::filesystem::path& file, std::string& bytes);

/// OBJ, which declares no counts: a file cut between two lines reads as a smaller mesh, which validate()
/// shows as boundary edges. A cut within a line is found if it leaves an incomplete line or vertices that no
/// face uses.
MeshFileContent check_obj(const std::filesystem::path& file, std::string& bytes);

/// VTK's PolyData as XML: see vtp_arrays.hpp. A cut at any byte is found.
MeshFileContent check_vtp(const std::filesystem::path& file, std::string& bytes);

/// VTK's legacy PolyData, ascii or binary, of any version up to 5.1. Cuts are found as in PLY up to the end
/// of the faces; the data of points and cells after them are not looked at.
MeshFileContent check_vtk(const std::filesystem::path& file, std::string& bytes);

}  // namespace impinge

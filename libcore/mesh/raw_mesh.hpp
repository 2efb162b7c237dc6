// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh from plain numbers, as a reader of files in another language hands it over.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// positions: x, y, z of each point in turn, mm. corners: three indices of points for each face in turn;
/// empty if every three points in turn are a face. Both are only read during the call.
struct RawMesh {
  std::span<const double> positions;       // three a point
  std::span<const std::uint32_t> corners;  // three a face
};

/// Points with equal coordinates become one, and faces that collapse thereby are dropped, as read_mesh() does
/// (mesh/io.hpp). `file` is the name in messages. FileError if the numbers are no whole points or faces, a
/// face names a point that is not there, a coordinate is NaN or infinite, or there is no face with an area.
TriangleMesh mesh_of(const std::filesystem::path& file, const RawMesh& raw);

/// Throws FileError if none of the faces has an area.
void require_area(const std::filesystem::path& file, const TriangleMesh& mesh);

}  // namespace impinge

// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a mesh from plain numbers, such as a file reader in another language gives.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// The numbers of a mesh; they are only read during the call. `corners` is empty if every three points in
/// turn are a face.
struct RawMesh {
  std::span<const double> positions;       // x, y, z of each point in turn, mm
  std::span<const std::uint32_t> corners;  // three indices of points for each face in turn
};

/// Makes the mesh. As in read_mesh() (mesh/io.hpp), points with equal coordinates become one, and faces that
/// collapse thereby are dropped. `file` is the name in messages. Throws FileError if the numbers are not
/// whole points or faces, a face names a point that does not exist, a coordinate is NaN or infinite, or no
/// face has an area.
TriangleMesh mesh_of(const std::filesystem::path& file, const RawMesh& raw);

/// Throws FileError if none of the faces has an area.
void require_area(const std::filesystem::path& file, const TriangleMesh& mesh);

}  // namespace impinge

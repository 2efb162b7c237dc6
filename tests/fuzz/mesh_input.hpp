// SPDX-License-Identifier: GPL-3.0-or-later
// An input of the fuzz targets on meshes: one byte that chooses the format, then the file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace impinge::test {

inline constexpr std::array<const char*, 6> kFormats{"mesh.ply", "mesh.stl", "mesh.obj",
                                                     "mesh.off", "mesh.vtp", "mesh.vtk"};

struct MeshInput {
  std::filesystem::path file;
  std::string bytes;
};

// Of at least one byte; '0' to '5' stand for the formats in their order.
inline MeshInput mesh_input(const std::uint8_t* data, std::size_t size) {
  return {kFormats[data[0] % kFormats.size()], std::string(data + 1, data + size)};
}

}  // namespace impinge::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh_format.hpp"

#include <string>

#include "files/file_error.hpp"

namespace impinge {

MeshFormat mesh_format(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (extension == ".ply") return MeshFormat::ply;
  if (extension == ".stl") return MeshFormat::stl;
  if (extension == ".obj") return MeshFormat::obj;
  if (extension == ".off") return MeshFormat::off;
  throw FileError(file,
                  extension.empty() ? "has no extension" : "has the unknown extension '" + extension + "'",
                  "use .ply, .stl, .obj or .off");
}

}  // namespace impinge

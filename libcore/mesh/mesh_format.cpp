// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh_format.hpp"

#include <algorithm>
#include <string>

#include "files/file_error.hpp"

namespace impinge {

MeshFormat mesh_format(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  for (std::size_t k = 0; k < words_of<MeshFormat>.size(); ++k) {
    if (extension == "." + std::string(words_of<MeshFormat>[k])) return static_cast<MeshFormat>(k);
  }
  throw FileError(file,
                  extension.empty() ? "has no extension" : "has the unknown extension '" + extension + "'",
                  "use .ply, .stl, .obj, .off, .vtp or .vtk");
}

}  // namespace impinge

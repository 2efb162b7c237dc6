// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/ply_series.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string_view>

#include "files/file_bytes.hpp"
#include "mesh/ply_bytes.hpp"

namespace impinge::lab {
namespace {

void require_usable(const TriangleMesh& mesh, std::span<const VertexSeries> states) {
  std::set<std::string_view> names{"x", "y", "z"};
  for (const VertexSeries& state : states) {
    if (state.property.empty() || state.property.find_first_of(" \t\r\n") != std::string::npos ||
        !names.insert(state.property).second) {
      throw std::invalid_argument("'" + state.property + "' cannot name a state in a PLY file");
    }
    if (state.values.size() != mesh.vertices.size()) {
      throw std::invalid_argument("state '" + state.property + "' has " +
                                  std::to_string(state.values.size()) + " values for " +
                                  std::to_string(mesh.vertices.size()) + " vertices");
    }
  }
}

std::string header(const TriangleMesh& mesh, std::span<const VertexSeries> states) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment lengths in millimetres\n";
  text += "element vertex " + std::to_string(mesh.vertices.size()) + '\n';
  for (const char* axis : {"x", "y", "z"}) text += std::string("property float ") + axis + '\n';
  for (const VertexSeries& state : states) text += "property float " + state.property + '\n';
  text += "element face " + std::to_string(mesh.faces.size()) + '\n';
  return text + "property list uchar int vertex_indices\nend_header\n";
}

}  // namespace

void write_ply_series(const std::filesystem::path& file, const TriangleMesh& mesh,
                      std::span<const VertexSeries> states) {
  require_usable(mesh, states);
  std::string bytes = header(mesh, states);
  bytes.reserve(bytes.size() + 4 * (3 + states.size()) * mesh.vertices.size() + 13 * mesh.faces.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    for (const double x : mesh.vertices[i]) append_value(bytes, static_cast<float>(x));
    for (const VertexSeries& state : states) append_value(bytes, state.values[i]);
  }
  append_faces(bytes, mesh);
  write_bytes(file, bytes);
}

}  // namespace impinge::lab

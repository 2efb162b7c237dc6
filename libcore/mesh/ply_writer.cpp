// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/ply_writer.hpp"

#include <algorithm>
#include <stdexcept>

#include "mesh/ply_bytes.hpp"

namespace impinge {
namespace {

std::string header(const TriangleMesh& mesh, const MeshNotes& notes) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment lengths in millimetres\n";
  if (const std::string space = space_of(notes); !space.empty()) text += "comment " + space + '\n';
  text += "element vertex " + std::to_string(mesh.vertices.size()) + '\n';
  text += "property double x\nproperty double y\nproperty double z\n";
  if (!notes.values.empty()) {
    text += "property double " + std::string(notes.values.front().name) + '\n';
    text += "property float quality\nproperty float u\nproperty float v\n";
  }
  if (!notes.colours.empty()) text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  text += "element face " + std::to_string(mesh.faces.size()) + '\n';
  return text + "property list uchar int vertex_indices\nend_header\n";
}

void append_vertex(std::string& bytes, const Vec3& v, const MeshNotes& notes, std::size_t i) {
  for (int k = 0; k < 3; ++k) append_value(bytes, v[k]);
  if (!notes.values.empty()) {
    const double value = notes.values.front().values[i];
    append_value(bytes, value);
    append_value(bytes, static_cast<float>(value));  // quality
    append_value(bytes, static_cast<float>(value));  // u
    append_value(bytes, 0.0F);                       // v
  }
  if (!notes.colours.empty()) {
    for (const std::uint8_t c : notes.colours[i]) bytes.push_back(static_cast<char>(c));
  }
}

bool usable_name(std::string_view name) {
  constexpr std::array<std::string_view, 9> kTaken{"x", "y",   "z",     "quality", "u",
                                                   "v", "red", "green", "blue"};
  const auto printable = [](unsigned char c) {
    return c > 0x20 && c < 0x7f && c != '<' && c != '&' && c != '"';
  };
  return !name.empty() && std::all_of(name.begin(), name.end(), printable) &&
         std::find(kTaken.begin(), kTaken.end(), name) == kTaken.end();
}

}  // namespace

std::string space_of(const MeshNotes& notes) {
  return notes.axes == "RAS" || notes.axes == "LPS" ? "SPACE=" + std::string(notes.axes) : "";
}

void check_notes(const TriangleMesh& mesh, const MeshNotes& notes) {
  const std::size_t n = mesh.vertices.size();
  for (const VertexValues& of : notes.values) {
    if (!usable_name(of.name))
      throw std::invalid_argument("'" + std::string(of.name) + "' cannot name a value in a mesh file");
    if (of.values.size() != n)
      throw std::invalid_argument("a mesh file takes one value a vertex: " + std::to_string(n) +
                                  " vertices, " + std::to_string(of.values.size()) + " values");
  }
  if (!notes.colours.empty() && notes.colours.size() != n)
    throw std::invalid_argument("a mesh file takes one colour a vertex: " + std::to_string(n) +
                                " vertices, " + std::to_string(notes.colours.size()) + " colours");
  for (const Face& face : mesh.faces) {
    if (*std::max_element(face.begin(), face.end()) >= n)
      throw std::invalid_argument(
          "a face of the mesh names a vertex that is not there: repair the mesh first");
  }
}

std::string ply_bytes(const TriangleMesh& mesh, const MeshNotes& notes) {
  check_notes(mesh, notes);
  std::string bytes = header(mesh, notes);
  bytes.reserve(bytes.size() + 47 * mesh.vertices.size() + 13 * mesh.faces.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) append_vertex(bytes, mesh.vertices[i], notes, i);
  append_faces(bytes, mesh);
  return bytes;
}

}  // namespace impinge

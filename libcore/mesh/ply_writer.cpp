// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/ply_writer.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "files/file_bytes.hpp"
#include "files/file_error.hpp"
#include "mesh/ply_bytes.hpp"

namespace impinge {
namespace {

struct VertexData {
  std::string_view property;
  std::span<const double> values;
  std::span<const Rgb> colours;
};

std::string header(const TriangleMesh& mesh, const VertexData& data) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment lengths in millimetres\n";
  text += "element vertex " + std::to_string(mesh.vertices.size()) + '\n';
  text += "property double x\nproperty double y\nproperty double z\n";
  if (!data.property.empty()) {
    text += "property double " + std::string(data.property) + '\n';
    text += "property float quality\nproperty float u\nproperty float v\n";
  }
  if (!data.colours.empty()) text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  text += "element face " + std::to_string(mesh.faces.size()) + '\n';
  return text + "property list uchar int vertex_indices\nend_header\n";
}

void append_vertex(std::string& bytes, const Vec3& v, const VertexData& data, std::size_t i) {
  for (int k = 0; k < 3; ++k) append_value(bytes, v[k]);
  if (!data.property.empty()) {
    append_value(bytes, data.values[i]);
    append_value(bytes, static_cast<float>(data.values[i]));  // quality
    append_value(bytes, static_cast<float>(data.values[i]));  // u
    append_value(bytes, 0.0F);                                // v
  }
  if (!data.colours.empty()) {
    for (const std::uint8_t c : data.colours[i]) bytes.push_back(static_cast<char>(c));
  }
}

std::string bytes_of(const TriangleMesh& mesh, const VertexData& data) {
  std::string bytes = header(mesh, data);
  bytes.reserve(bytes.size() + 47 * mesh.vertices.size() + 13 * mesh.faces.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) append_vertex(bytes, mesh.vertices[i], data, i);
  append_faces(bytes, mesh);
  return bytes;
}

bool names_all_vertices(const TriangleMesh& mesh) {
  return std::ranges::all_of(
      mesh.faces, [&mesh](const Face& face) { return std::ranges::max(face) < mesh.vertices.size(); });
}

void require_vertices(const std::filesystem::path& file, const TriangleMesh& mesh) {
  if (names_all_vertices(mesh)) return;
  throw FileError(file, "is not written, a face names a vertex that is not there", "repair the mesh first");
}

bool usable_name(std::string_view name) {
  constexpr std::array<std::string_view, 9> kTaken{"x", "y",   "z",     "quality", "u",
                                                   "v", "red", "green", "blue"};
  const auto printable = [](unsigned char c) { return c > 0x20 && c < 0x7f; };
  return !name.empty() && std::ranges::all_of(name, printable) &&
         std::ranges::find(kTaken, name) == kTaken.end();
}

}  // namespace

void write_ply(const std::filesystem::path& file, const TriangleMesh& mesh) {
  require_vertices(file, mesh);
  write_bytes(file, bytes_of(mesh, {}));
}

void write_ply(const std::filesystem::path& file, const TriangleMesh& mesh, std::string_view property,
               std::span<const double> values, std::span<const Rgb> colours) {
  require_vertices(file, mesh);
  write_bytes(file, ply_bytes(mesh, property, values, colours));
}

std::string ply_bytes(const TriangleMesh& mesh, std::string_view property, std::span<const double> values,
                      std::span<const Rgb> colours) {
  const std::size_t n = mesh.vertices.size();
  if (values.size() != n || (!colours.empty() && colours.size() != n)) {
    throw std::invalid_argument("a PLY file takes one value and one colour a vertex: " + std::to_string(n) +
                                " vertices, " + std::to_string(values.size()) + " values, " +
                                std::to_string(colours.size()) + " colours");
  }
  if (!usable_name(property)) {
    throw std::invalid_argument("'" + std::string(property) + "' cannot name a value in a PLY file");
  }
  if (!names_all_vertices(mesh)) {
    throw std::invalid_argument("a face of the mesh names a vertex that is not there: repair the mesh first");
  }
  return bytes_of(mesh, {property, values, colours});
}

}  // namespace impinge

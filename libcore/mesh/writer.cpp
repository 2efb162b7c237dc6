// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <string>

#include "files/file_bytes.hpp"
#include "mesh/io.hpp"
#include "mesh/mesh_format.hpp"
#include "mesh/ply_bytes.hpp"
#include "mesh/vtk_writer.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

void require_writable(const fs::path& file, const TriangleMesh& mesh) {
  const char* reason = nullptr;
  if (mesh.faces.empty()) reason = "the mesh has no faces";
  if (!std::ranges::all_of(mesh.vertices, [](const Vec3& v) { return v.allFinite(); })) {
    reason = "the mesh has coordinates that are NaN or infinite";
  }
  for (const Face& face : mesh.faces) {
    if (std::ranges::max(face) >= mesh.vertices.size()) reason = "a face names a vertex that is not there";
  }
  if (reason != nullptr)
    throw FileError(file, std::string("is not written, ") + reason, "repair the mesh first");
}

std::string face_lines(const TriangleMesh& mesh, const std::string& start, VertexIndex first) {
  std::string text;
  for (const auto& [a, b, c] : mesh.faces)
    text += start + std::to_string(a + first) + ' ' + std::to_string(b + first) + ' ' +
            std::to_string(c + first) + '\n';
  return text;
}

std::string off_bytes(const TriangleMesh& mesh) {
  return "OFF\n" + std::to_string(mesh.vertices.size()) + ' ' + std::to_string(mesh.faces.size()) + " 0\n" +
         point_lines(mesh, "") + face_lines(mesh, "3 ", 0);
}

std::string obj_bytes(const TriangleMesh& mesh, const MeshNotes& notes) {
  return "# lengths in millimetres " + space_of(notes) + '\n' + point_lines(mesh, "v ") +
         face_lines(mesh, "f ", 1);
}

std::string stl_bytes(const TriangleMesh& mesh, const MeshNotes& notes) {
  std::string bytes = "lengths in millimetres " + space_of(notes);
  bytes.resize(80, ' ');
  append_bits(bytes, static_cast<std::uint32_t>(mesh.faces.size()));
  for (const Face& face : mesh.faces) {
    const auto [a, b, c] = corners_of(mesh, face);
    for (const Vec3& v : {area_vector(mesh, face).stableNormalized(), a, b, c}) {
      for (int k = 0; k < 3; ++k) append_value(bytes, static_cast<float>(v[k]));
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

}  // namespace

std::string mesh_bytes(const fs::path& file, const TriangleMesh& mesh, const MeshNotes& notes) {
  const MeshFormat format = mesh_format(file);
  require_writable(file, mesh);
  check_notes(mesh, notes);
  switch (format) {
    case MeshFormat::ply:
      return ply_bytes(mesh, notes);
    case MeshFormat::stl:
      return stl_bytes(mesh, notes);
    case MeshFormat::obj:
      return obj_bytes(mesh, notes);
    case MeshFormat::off:
      return off_bytes(mesh);
    case MeshFormat::vtp:
      return vtp_bytes(mesh, notes);
    case MeshFormat::vtk:
      return vtk_bytes(mesh, notes);
  }
  return {};
}

void write_mesh(const fs::path& file, const TriangleMesh& mesh, const MeshNotes& notes) {
  write_bytes(file, mesh_bytes(file, mesh, notes));
}

}  // namespace impinge

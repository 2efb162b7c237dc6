// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files as bytes, written independently of the library's own writers.
#pragma once

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace impinge::test {

inline std::string contents(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

inline std::string ply_header(const std::string& format, std::size_t vertices, std::size_t faces) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(faces) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

inline void append_bits(std::string& bytes, std::uint32_t bits, bool big_endian = false) {
  for (unsigned k = 0; k < 4; ++k)
    bytes.push_back(static_cast<char>(bits >> 8 * (big_endian ? 3 - k : k) & 0xffU));
}

inline void append_float(std::string& bytes, double x, bool big_endian = false) {
  append_bits(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(x)), big_endian);
}

inline std::string binary_ply(const TriangleMesh& mesh, bool big_endian = false) {
  std::string bytes = ply_header(big_endian ? "binary_big_endian" : "binary_little_endian",
                                 mesh.vertices.size(), mesh.faces.size());
  for (const Vec3& v : mesh.vertices) {
    for (const double x : v) append_float(bytes, x, big_endian);
  }
  for (const Face& face : mesh.faces) {
    bytes.push_back(3);
    for (const VertexIndex v : face) append_bits(bytes, v, big_endian);
  }
  return bytes;
}

inline std::string vertex_lines(const TriangleMesh& mesh, const std::string& start) {
  std::ostringstream text;
  text.precision(9);
  for (const Vec3& v : mesh.vertices) text << start << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  return text.str();
}

inline std::string face_lines(const TriangleMesh& mesh, const std::string& start, VertexIndex base) {
  std::ostringstream text;
  for (const auto& [a, b, c] : mesh.faces)
    text << start << a + base << ' ' << b + base << ' ' << c + base << '\n';
  return text.str();
}

inline std::string ascii_ply(const TriangleMesh& mesh) {
  return ply_header("ascii", mesh.vertices.size(), mesh.faces.size()) + vertex_lines(mesh, "") +
         face_lines(mesh, "3 ", 0);
}

inline std::string off(const TriangleMesh& mesh) {
  return "OFF\n" + std::to_string(mesh.vertices.size()) + ' ' + std::to_string(mesh.faces.size()) + " 0\n" +
         vertex_lines(mesh, "") + face_lines(mesh, "3 ", 0);
}

inline std::string obj(const TriangleMesh& mesh) {
  return vertex_lines(mesh, "v ") + face_lines(mesh, "f ", 1);
}

inline std::string binary_stl(const TriangleMesh& mesh, std::string header = "made by a test") {
  header.resize(80, ' ');
  append_bits(header, static_cast<std::uint32_t>(mesh.faces.size()));
  for (const Face& face : mesh.faces) {
    for (int k = 0; k < 3; ++k) append_float(header, 0.0);
    for (std::size_t k = 0; k < 3; ++k) {
      for (const double x : corner(mesh, face, k)) append_float(header, x);
    }
    header.append(2, '\0');
  }
  return header;
}

inline std::string ascii_stl(const TriangleMesh& mesh, const std::string& name = "made_by_a_test") {
  std::ostringstream text;
  text.precision(9);
  text << "solid " << name << '\n';
  for (const Face& face : mesh.faces) {
    text << "facet normal 0 0 0\n outer loop\n";
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& v = corner(mesh, face, k);
      text << "  vertex " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
    }
    text << " endloop\nendfacet\n";
  }
  text << "endsolid " << name << '\n';
  return text.str();
}

// VTK's PolyData as text: XML, and the legacy format of versions before 5.
inline std::string vtp(const TriangleMesh& mesh) {
  std::string ends;
  for (std::size_t k = 1; k <= mesh.faces.size(); ++k) ends += std::to_string(3 * k) + '\n';
  const auto array = [](const std::string& name, const std::string& numbers) {
    return "<DataArray type=\"Float32\" Name=\"" + name + "\" format=\"ascii\">\n" + numbers +
           "</DataArray>\n";
  };
  return "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"" +
         std::to_string(mesh.vertices.size()) + "\" NumberOfPolys=\"" + std::to_string(mesh.faces.size()) +
         "\">\n<Points>" + array("Points", vertex_lines(mesh, "")) + "</Points>\n<Polys>" +
         array("connectivity", face_lines(mesh, "", 0)) + array("offsets", ends) +
         "</Polys></Piece></PolyData></VTKFile>\n";
}

inline std::string vtk(const TriangleMesh& mesh) {
  const std::size_t faces = mesh.faces.size();
  return "# vtk DataFile Version 3.0\nmade by a test\nASCII\nDATASET POLYDATA\nPOINTS " +
         std::to_string(mesh.vertices.size()) + " float\n" + vertex_lines(mesh, "") + "POLYGONS " +
         std::to_string(faces) + ' ' + std::to_string(4 * faces) + '\n' + face_lines(mesh, "3 ", 0);
}

}  // namespace impinge::test

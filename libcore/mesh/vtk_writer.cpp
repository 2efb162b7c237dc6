// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/vtk_writer.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <concepts>
#include <cstdint>

#include "mesh/ply_bytes.hpp"

namespace impinge {
namespace {

std::string base64_of(const std::string& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t k = i; k < i + 3; ++k)
      bits = bits << 8U | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U);
    for (const unsigned shift : {18U, 12U, 6U, 0U}) text += kDigits[bits >> shift & 63U];
  }
  for (std::size_t k = bytes.size() % 3; k > 0 && k < 3; ++k) text[text.size() - 3 + k] = '=';
  return text;
}

std::string data_array(const std::string& attributes, const std::string& text) {
  return "<DataArray " + attributes + ">\n" + text + "\n</DataArray>\n";
}

std::string polys_text(const TriangleMesh& mesh) {
  std::string corners;
  std::string ends;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (const VertexIndex v : mesh.faces[f]) corners += std::to_string(v) + ' ';
    ends += std::to_string(3 * f + 3) + ' ';
  }
  return data_array(R"(type="Int32" Name="connectivity" format="ascii")", corners) +
         data_array(R"(type="Int32" Name="offsets" format="ascii")", ends);
}

// The values in base64, with their size in bytes before them.
std::string values_text(const VertexValues& of) {
  std::string bytes;
  append_bits(bytes, static_cast<std::uint32_t>(of.values.size() * sizeof(double)));
  for (const double x : of.values) append_value(bytes, x);
  return data_array("type=\"Float64\" Name=\"" + std::string(of.name) + "\" format=\"binary\"",
                    base64_of(bytes));
}

// The axes as the codes of their letters, and a 0.
std::string space_text(const MeshNotes& notes) {
  if (space_of(notes).empty()) return "";
  std::string codes;
  for (const char c : notes.axes) codes += std::to_string(static_cast<int>(c)) + ' ';
  return R"(<FieldData>
<Array type="String" Name="SPACE" NumberOfTuples="1" format="ascii">)" +
         codes + "0</Array>\n</FieldData>\n";
}

template <std::unsigned_integral Bits>
void append_high_first(std::string& bytes, Bits bits) {
  for (std::size_t k = sizeof bits; k-- > 0;) bytes.push_back(static_cast<char>(bits >> 8 * k & 0xffU));
}

void append_high_first(std::string& bytes, double x) {
  append_high_first(bytes, std::bit_cast<std::uint64_t>(x));
}

}  // namespace

std::string point_lines(const TriangleMesh& mesh, const std::string& start) {
  std::string text;
  std::array<char, 32> digits{};
  for (const Vec3& v : mesh.vertices) {
    text += start;
    for (int k = 0; k < 3; ++k) {
      text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), v[k]).ptr);
      text += k < 2 ? ' ' : '\n';
    }
  }
  return text;
}

std::string vtp_bytes(const TriangleMesh& mesh, const MeshNotes& notes) {
  std::string text = R"(<?xml version="1.0"?>
<!-- lengths in millimetres -->
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian">
<PolyData>
)" + space_text(notes) +
                     "<Piece NumberOfPoints=\"" + std::to_string(mesh.vertices.size()) +
                     R"(" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys=")" +
                     std::to_string(mesh.faces.size()) + "\">\n";
  if (!notes.values.empty()) {
    text += "<PointData Scalars=\"" + std::string(notes.values.front().name) + "\">\n";
    for (const VertexValues& of : notes.values) text += values_text(of);
    text += "</PointData>\n";
  }
  return text + "<Points>\n" +
         data_array(R"(type="Float64" NumberOfComponents="3" format="ascii")", point_lines(mesh, "")) +
         "</Points>\n<Polys>\n" + polys_text(mesh) + "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

// All values but the first are fields, as readers take one scalar.
std::string vtk_bytes(const TriangleMesh& mesh, const MeshNotes& notes) {
  const std::string points = std::to_string(mesh.vertices.size());
  const std::size_t faces = mesh.faces.size();
  std::string bytes = "# vtk DataFile Version 3.0\nlengths in millimetres " + space_of(notes) +
                      "\nBINARY\nDATASET POLYDATA\nPOINTS " + points + " double\n";
  for (const Vec3& v : mesh.vertices) {
    for (int k = 0; k < 3; ++k) append_high_first(bytes, v[k]);
  }
  bytes += "\nPOLYGONS " + std::to_string(faces) + ' ' + std::to_string(4 * faces) + '\n';
  for (const Face& face : mesh.faces) {
    append_high_first(bytes, std::uint32_t{3});
    for (const VertexIndex v : face) append_high_first(bytes, v);
  }
  if (!notes.values.empty()) bytes += "\nPOINT_DATA " + points;
  for (std::size_t k = 0; k < notes.values.size(); ++k) {
    const std::string name(notes.values[k].name);
    if (k == 1) bytes += "\nFIELD FieldData " + std::to_string(notes.values.size() - 1);
    bytes += k == 0 ? "\nSCALARS " : "\n";
    bytes += name;
    bytes += k == 0 ? " double 1\nLOOKUP_TABLE default\n" : " 1 " + points + " double\n";
    for (const double x : notes.values[k].values) append_high_first(bytes, x);
  }
  return bytes + '\n';
}

}  // namespace impinge

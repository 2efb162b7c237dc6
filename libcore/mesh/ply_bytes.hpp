// SPDX-License-Identifier: GPL-3.0-or-later
// Writes values and faces as in a binary little-endian PLY file.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Appends the bytes of an unsigned number, the lowest first.
template <std::unsigned_integral Bits>
void append_bits(std::string& bytes, Bits bits) {
  for (std::size_t k = 0; k < sizeof bits; ++k) bytes.push_back(static_cast<char>(bits >> 8 * k & 0xffU));
}

/// Appends a number as "double".
inline void append_value(std::string& bytes, double x) {
  append_bits(bytes, std::bit_cast<std::uint64_t>(x));
}
/// Appends a number as "float".
inline void append_value(std::string& bytes, float x) { append_bits(bytes, std::bit_cast<std::uint32_t>(x)); }

/// Appends the faces as "property list uchar int vertex_indices".
inline void append_faces(std::string& bytes, const TriangleMesh& mesh) {
  for (const Face& face : mesh.faces) {
    bytes.push_back(3);
    for (const VertexIndex v : face) append_bits(bytes, v);
  }
}

}  // namespace impinge

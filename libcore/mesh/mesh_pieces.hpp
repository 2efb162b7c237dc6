// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the connected pieces of a mesh, such as a bone and specks that a segmentation left beside it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Faces that are connected through vertices.
struct MeshPiece {
  std::vector<std::size_t> faces;  // their numbers in the mesh, rising
  double area = 0.0;               // mm^2
  double across = 0.0;             // mm, the longest side of its box along the axes
};

/// All pieces of a mesh, the one with the largest area first.
std::vector<MeshPiece> mesh_pieces(const TriangleMesh& mesh);

/// Keeps only the largest piece, its vertices and faces in their order. Returns a text that says what was
/// left out, empty if there was only one piece.
std::string keep_largest_piece(TriangleMesh& mesh);

/// The sizes of pieces as text, such as "32.1, 1.0 and 0.9 mm across"; at most the first four.
std::string sizes_text(std::span<const MeshPiece> pieces);

}  // namespace impinge

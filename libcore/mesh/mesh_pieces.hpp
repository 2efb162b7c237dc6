// SPDX-License-Identifier: GPL-3.0-or-later
// The connected pieces of a mesh: a bone, and specks that a segmentation left beside it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Faces that are connected through vertices.
struct MeshPiece {
  std::vector<std::size_t> faces;  // their places in the mesh, rising
  double area = 0.0;               // mm^2
  double across = 0.0;             // mm, the longest side of its box along the axes
};

/// All pieces of a mesh, the one of the largest area first.
std::vector<MeshPiece> mesh_pieces(const TriangleMesh& mesh);

/// Leaves only the largest piece, its vertices and faces in their order, and says what was left out; empty if
/// there was but one.
std::string keep_largest_piece(TriangleMesh& mesh);

/// Their sizes as text, such as "32.1, 1.0 and 0.9 mm across"; the first four of many.
std::string sizes_text(std::span<const MeshPiece> pieces);

}  // namespace impinge

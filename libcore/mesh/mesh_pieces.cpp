// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh_pieces.hpp"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

#include "files/formatted.hpp"
#include "mesh/disjoint_sets.hpp"

namespace impinge {
namespace {

TriangleMesh one_piece(const TriangleMesh& mesh, const MeshPiece& piece) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const std::size_t f : piece.faces) {
    for (const VertexIndex v : mesh.faces[f]) used[v] = true;
  }
  TriangleMesh alone;
  std::vector<VertexIndex> place(mesh.vertices.size(), 0);
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    place[v] = static_cast<VertexIndex>(alone.vertices.size());
    alone.vertices.push_back(mesh.vertices[v]);
  }
  for (const std::size_t f : piece.faces) {
    Face face = mesh.faces[f];
    for (VertexIndex& v : face) v = place[v];
    alone.faces.push_back(face);
  }
  return alone;
}

}  // namespace

std::vector<MeshPiece> mesh_pieces(const TriangleMesh& mesh) {
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  DisjointSets sets(mesh.vertices.size());
  for (const Face& face : mesh.faces) {
    for (const VertexIndex v : face) sets.join(face[0], v, false);
  }
  std::vector<MeshPiece> pieces;
  std::vector<Eigen::AlignedBox3d> boxes;
  std::vector<std::size_t> piece_of(mesh.vertices.size(), kNone);  // by the root of a set
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Face& face = mesh.faces[f];
    std::size_t& k = piece_of[sets.find(face[0]).root];
    if (k == kNone) {
      k = pieces.size();
      pieces.emplace_back();
      boxes.emplace_back();
    }
    pieces[k].faces.push_back(f);
    pieces[k].area += 0.5 * area_vector(mesh, face).norm();
    for (const VertexIndex v : face) boxes[k].extend(mesh.vertices[v]);
  }
  for (std::size_t k = 0; k < pieces.size(); ++k) pieces[k].across = boxes[k].sizes().maxCoeff();
  std::ranges::stable_sort(pieces, std::ranges::greater(), &MeshPiece::area);
  return pieces;
}

std::string sizes_text(std::span<const MeshPiece> pieces) {
  constexpr std::size_t kMost = 4;
  std::string text;
  for (std::size_t k = 0; k < std::min(pieces.size(), kMost); ++k) {
    const bool last = k + 1 == pieces.size();
    text += (k == 0 ? "" : last ? " and " : ", ") + formatted("%.1f", pieces[k].across);
  }
  return text + (pieces.size() > kMost ? " mm across and others" : " mm across");
}

std::string keep_largest_piece(TriangleMesh& mesh) {
  const std::vector<MeshPiece> pieces = mesh_pieces(mesh);
  if (pieces.size() < 2) return {};
  mesh = one_piece(mesh, pieces.front());
  const std::span<const MeshPiece> others = std::span(pieces).subspan(1);
  return formatted("%zu of its %zu pieces left out, ", others.size(), pieces.size()) + sizes_text(others);
}

}  // namespace impinge

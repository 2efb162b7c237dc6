// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of a mesh, each with the faces that use it.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

using Edge = std::array<VertexIndex, 2>;  // the two ends

/// Side k of face f, from its corner k to its corner k + 1.
struct HalfEdge {
  std::size_t face = 0;  // place among the faces of the mesh
  std::size_t side = 0;  // 0, 1 or 2
};

/// The two ends of a side, in the direction in which the face runs through it.
inline Edge ends(const TriangleMesh& mesh, HalfEdge h) {
  return {mesh.faces[h.face][h.side], mesh.faces[h.face][(h.side + 1) % 3]};
}

/// A face takes part in the topology of a mesh when its three corners exist and differ.
bool has_three_corners(const TriangleMesh& mesh, const Face& face);

/// Throws std::invalid_argument for more faces than a third of 2^32.
void require_countable_edges(const TriangleMesh& mesh);

/// Calls visit(half_edges) for each edge of the faces with three corners; its half-edges come in the order of
/// the faces. Takes linear time. Throws std::invalid_argument for more faces than a third of 2^32.
void for_each_edge(const TriangleMesh& mesh, const std::function<void(std::span<const HalfEdge>)>& visit);

/// The same for the edges whose lower end (the vertex with the smaller index) is marked.
void for_each_edge(const TriangleMesh& mesh, const std::vector<bool>& lower_ends,
                   const std::function<void(std::span<const HalfEdge>)>& visit);

/// The half-edges of all faces with three corners, edge by edge, for one edge in the order of the faces. Edge
/// e has half_edges[first[e]] .. half_edges[first[e + 1] - 1].
struct EdgeList {
  std::vector<HalfEdge> half_edges;                      // edge by edge
  std::vector<std::size_t> first;                        // one longer than the number of edges
  std::size_t size() const { return first.size() - 1; }  // number of edges
  /// The half-edges of edge e, one for each of its faces.
  std::span<const HalfEdge> operator[](std::size_t e) const {
    return std::span(half_edges).subspan(first[e], first[e + 1] - first[e]);
  }
};
EdgeList edges(const TriangleMesh& mesh);  // every edge of the mesh, with its faces

/// Edges with a single face, in the direction of that face (surface to the left, seen from outside) and in
/// the order of the faces.
std::vector<Edge> boundary_edges(const TriangleMesh& mesh);

}  // namespace impinge
